package org.sitaf.server.access.session;

import io.swagger.v3.oas.annotations.Hidden;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.net.URI;
import org.sitaf.server.audit.Audit;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.RestController;

/** Opens sign-in links. */
@RestController
@Hidden
class SignInLinkController {
  private final SignInLinks links;
  private final Sessions sessions;
  private final Audit audit;

  SignInLinkController(SignInLinks links, Sessions sessions, Audit audit) {
    this.links = links;
    this.sessions = sessions;
    this.audit = audit;
  }

  @GetMapping("/open/{code}")
  ResponseEntity<Void> open(
      @PathVariable String code, HttpServletRequest request, HttpServletResponse response) {
    String target =
        links
            .use(code)
            .map(user -> sessions.begin(user, request, response))
            .map(
                caller -> {
                  audit.record(
                      caller.name(), "openLink", caller.name(), "done", request.getRemoteAddr());
                  return "/";
                })
            .orElse("/sign-in?link=expired");
    return ResponseEntity.status(HttpStatus.SEE_OTHER).location(URI.create(target)).build();
  }
}
