package org.sitaf.server.access.session;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.Parameter;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import jakarta.servlet.http.HttpSession;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Role;
import org.sitaf.server.access.user.User;
import org.sitaf.server.access.user.Users;
import org.sitaf.server.audit.Audit;
import org.sitaf.server.error.RequestException;
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
                  "a user with a session, an API token, or the command that started the server")
          Caller.Kind kind) {
    static CallerView of(Caller caller) {
      return new CallerView(caller.name(), caller.role(), caller.kind());
    }
  }

  @Schema(name = "SignInLink")
  record LinkView(
      @Schema(description = "path on this server that opens the portal signed in; can be used once")
          String path) {}

  @GetMapping
  @Operation(operationId = "getSession", summary = "Returns the caller and its role")
  CallerView get() {
    return CallerView.of(Caller.current());
  }

  @PostMapping
  @Operation(
      operationId = "signIn",
      summary = "Signs in",
      description =
          "The response sets a session cookie. 401: wrong name or password; 429: too many attempts;"
              + " 503: too many concurrent sign-ins. Retry-After contains the time to wait in"
              + " seconds.")
  CallerView signIn(
      @RequestBody SignIn credentials,
      @Parameter(hidden = true) HttpServletRequest request,
      @Parameter(hidden = true) HttpServletResponse response) {
    if (credentials.name() == null || credentials.password() == null) {
      throw RequestException.malformed("name and password must be given.");
    }
    request.setAttribute(Audit.SUBJECT, credentials.name());
    String address = request.getRemoteAddr();
    String name = Users.normal(credentials.name());
    limit.attempt(address, name);
    User user =
        users
            .signIn(name, credentials.password())
            .orElseThrow(() -> RequestException.unauthenticated("Wrong name or password."));
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
      throw RequestException.forbidden(
          "Sign in to change your password; a token cannot change it.");
    }
    if (change.current() == null || change.next() == null) {
      throw RequestException.malformed("current and next must be given.");
    }
    limit.attempt(request.getRemoteAddr(), caller.name());
    users.changePassword(caller.personId(), change.current(), change.next());
    limit.succeeded(request.getRemoteAddr(), caller.name());
    sessions.begin(users.find(caller.personId()), request, response);
  }

  @PostMapping("/link")
  @Operation(
      operationId = "createSignInLink",
      summary = "Creates a link that opens the portal signed in",
      description =
          "The link can be used once. Only the command that started the server on the same machine"
              + " can create it.")
  LinkView createLink() {
    if (Caller.current().kind() != Caller.Kind.LAUNCHER) {
      throw RequestException.forbidden(
          "Only the command that started the server can create sign-in links.");
    }
    User user =
        users
            .firstAdministrator()
            .orElseThrow(
                () -> RequestException.conflict("There is no enabled administrator to sign in."));
    return new LinkView("/open/" + links.create(user.id()));
  }
}
