package org.sitaf.server.access.session;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.HttpSession;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.user.User;
import org.springframework.security.core.context.SecurityContext;
import org.springframework.security.core.context.SecurityContextHolder;
import org.springframework.security.web.context.HttpSessionSecurityContextRepository;
import org.springframework.security.web.context.SecurityContextRepository;
import org.springframework.stereotype.Component;

/** Creates sessions. */
@Component
class Sessions {
  private final SecurityContextRepository contexts = new HttpSessionSecurityContextRepository();

  /** Creates a session for a user and ends the browser's former one. */
  Caller begin(User user, HttpServletRequest request, HttpServletResponse response) {
    HttpSession former = request.getSession(false);
    if (former != null) {
      former.invalidate();
    }
    Caller caller = user.caller();
    SecurityContext context = SecurityContextHolder.createEmptyContext();
    context.setAuthentication(caller.authentication());
    SecurityContextHolder.setContext(context);
    contexts.saveContext(context, request, response);
    return caller;
  }
}
