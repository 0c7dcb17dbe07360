package org.sitaf.server.access.user;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Role;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/users")
@Tag(name = "users")
class UserController {
  private final Users users;

  UserController(Users users) {
    this.users = users;
  }

  @Schema(name = "UserRequest")
  record UserRequest(
      @Schema(description = "1 to 60 letters, digits, '.', '_', '@' or '-'; stored in lower case")
          String name,
      Role role) {}

  @Schema(name = "UserChange", description = "absent fields are not changed")
  record UserChange(@Nullable Role role, @Nullable Boolean enabled) {}

  @Schema(name = "User")
  record UserView(
      String id,
      String name,
      Role role,
      @Schema(description = "whether the user can sign in") boolean enabled,
      Instant created,
      @Nullable Instant lastSignIn) {
    static UserView of(User user) {
      return new UserView(
          user.id(),
          user.name(),
          user.role(),
          user.enabled(),
          user.created(),
          user.lastSignIn().orElse(null));
    }
  }

  @Schema(name = "UserWithPassword")
  record UserWithPassword(
      UserView user, @Schema(description = "shown only once, not stored") String password) {
    static UserWithPassword of(Users.WithPassword created) {
      return new UserWithPassword(UserView.of(created.user()), created.password());
    }
  }

  @GetMapping
  @Operation(operationId = "listUsers", summary = "Lists users by name")
  Listing<UserView> list(
      @RequestParam(defaultValue = "0") int page, @RequestParam(defaultValue = "50") int size) {
    PageRequest pageRequest = Listing.request(page, size, Sort.unsorted());
    return new Listing<>(
        users.list(pageRequest).stream().map(UserView::of).toList(), page, size, users.count());
  }

  @PostMapping
  @Operation(
      operationId = "createUser",
      summary = "Creates a user",
      description = "The response contains a generated password, which is shown only once.")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<UserWithPassword> create(@RequestBody UserRequest request) {
    if (request.name() == null || request.role() == null) {
      throw RequestException.malformed("name and role must be given.");
    }
    UserWithPassword created = UserWithPassword.of(users.create(request.name(), request.role()));
    return ResponseEntity.created(URI.create("/api/v1/users/" + created.user().id())).body(created);
  }

  @GetMapping("/{id}")
  @Operation(operationId = "getUser", summary = "Returns a user")
  UserView get(@PathVariable String id) {
    return UserView.of(users.find(id));
  }

  @PatchMapping("/{id}")
  @Operation(
      operationId = "changeUser",
      summary = "Changes the role of a user, or disables the user",
      description = "The user's sessions end. Fails with 409 for the only administrator.")
  UserView change(@PathVariable String id, @RequestBody UserChange change) {
    return UserView.of(users.change(id, change.role(), change.enabled()));
  }

  @PostMapping("/{id}/password")
  @Operation(
      operationId = "resetPassword",
      summary = "Generates a new password, which is shown only once",
      description = "The user's sessions end.")
  UserWithPassword resetPassword(@PathVariable String id) {
    return UserWithPassword.of(users.resetPassword(id));
  }

  @DeleteMapping("/{id}")
  @Operation(
      operationId = "deleteUser",
      summary = "Deletes a user and the user's tokens",
      description = "The user's sessions end. Fails with 409 for the only administrator.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    users.delete(id);
  }
}
