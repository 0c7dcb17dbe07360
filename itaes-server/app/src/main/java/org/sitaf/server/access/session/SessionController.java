package org.sitaf.server.access.session;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.HttpSession;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Denial;
import org.sitaf.server.access.Role;
import org.sitaf.server.access.user.User;
import org.sitaf.server.access.user.Users;
import org.sitaf.server.audit.Audit;
import org.sitaf.server.refusal.Refusal;
import org.springframework.http.HttpStatus;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/session")
@Tag(name = "session")
class SessionController {
  private final Users users;
  private final SignInLimit limit;
  private final SignInLinks links;
  private final Sessions sessions;

  SessionController(Users users, SignInLimit limit, SignInLinks links, Sessions sessions) {
    this.users = users;
    this.limit = limit;
    this.links = links;
    this.sessions = sessions;
  }

  @Schema(name = "SignIn")
  record SignIn(String name, String password) {}

  @Schema(name = "PasswordChange")
  record PasswordChange(
      String current, @Schema(description = "at least 12 characters") String next) {}

  @Schema(name = "Caller")
  record CallerView(
      String name,
      Role role,
      @Schema(
              description =
                  "a person in a session, a token, or the command that started the server")
          Caller.Kind kind) {
    static CallerView of(Caller caller) {
      return new CallerView(caller.name(), caller.role(), caller.kind());
    }
  }

  @Schema(name = "SignInLink")
  record LinkView(
      @Schema(description = "opens the portal signed in, once; below the server's address")
          String path) {}

  @GetMapping
  @Operation(operationId = "getSession", summary = "Who you are, and what you may do")
  CallerView get() {
    return CallerView.of(Caller.current());
  }

  @PostMapping
  @Operation(
      operationId = "signIn",
      summary = "Signs in",
      description =
          "The answer sets the cookie of a session. 401: name or password are wrong; 429: too many"
              + " attempts, and 503: too many people sign in at this moment; Retry-After says for"
              + " how long.")
  CallerView signIn(
      @RequestBody SignIn credentials,
      @Parameter(hidden = true) HttpServletRequest request,
      @Parameter(hidden = true) HttpServletResponse response) {
    if (credentials.name() == null || credentials.password() == null) {
      throw Refusal.malformed("name and password must be given.");
    }
    request.setAttribute(Audit.SUBJECT, credentials.name());
    String address = request.getRemoteAddr();
    String name = Users.normal(credentials.name());
    limit.attempt(address, name);
    User user =
        users
            .signIn(name, credentials.password())
            .orElseThrow(() -> Denial.unknown("Name or password are wrong."));
    limit.succeeded(address, name);
    return CallerView.of(sessions.begin(user, request, response));
  }

  @DeleteMapping
  @Operation(operationId = "signOut", summary = "Ends the session")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void signOut(@Parameter(hidden = true) HttpServletRequest request) {
    HttpSession session = request.getSession(false);
    if (session != null) {
      session.invalidate();
    }
  }

  @PutMapping("/password")
  @Operation(
      operationId = "changePassword",
      summary = "Changes your password",
      description = "Your other sessions end.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void changePassword(
      @RequestBody PasswordChange change,
      @Parameter(hidden = true) HttpServletRequest request,
      @Parameter(hidden = true) HttpServletResponse response) {
    Caller caller = Caller.current();
    if (caller.kind() != Caller.Kind.PERSON || caller.personId() == null) {
      throw Denial.forbidden("A password is changed by the person whose it is, in a session.");
    }
    if (change.current() == null || change.next() == null) {
      throw Refusal.malformed("current and next must be given.");
    }
    limit.attempt(request.getRemoteAddr(), caller.name());
    users.changePassword(caller.personId(), change.current(), change.next());
    limit.succeeded(request.getRemoteAddr(), caller.name());
    sessions.begin(users.find(caller.personId()), request, response);
  }

  @PostMapping("/link")
  @Operation(
      operationId = "createSignInLink",
      summary = "Makes an address that opens the portal signed in, once",
      description =
          "For the command that started the server on its own machine, whose person need not type a"
              + " password.")
  LinkView createLink() {
    if (Caller.current().kind() != Caller.Kind.LAUNCHER) {
      throw Denial.forbidden("Only the command that started the server makes such links.");
    }
    User user =
        users
            .firstAdministrator()
            .orElseThrow(() -> Refusal.conflict("There is no administrator to sign in as."));
    return new LinkView("/open/" + links.create(user.id()));
  }
}
