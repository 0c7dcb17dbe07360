package org.sitaf.server.access.token;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Role;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.web.Listing;
import org.springframework.data.domain.PageRequest;
import org.springframework.data.domain.Sort;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RequestParam;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1/tokens")
@Tag(name = "tokens")
class TokenController {
  private static final int MAX_DAYS = 366;

  private final ApiTokens tokens;

  TokenController(ApiTokens tokens) {
    this.tokens = tokens;
  }

  @Schema(name = "TokenRequest")
  record TokenRequest(
      @Schema(description = "what it is for") String name,
      @Schema(description = "upper limit of its permissions; at most your own role") Role role,
      @Schema(description = "how long it is valid, 1 to 366 days") int days) {}

  @Schema(name = "Token")
  record TokenView(
      String id,
      String name,
      @Schema(description = "name of the user") String owner,
      Role role,
      Instant created,
      Instant expires,
      @Schema(description = "to the minute; absent if never used") @Nullable Instant lastUsed) {
    static TokenView of(ApiToken token) {
      return new TokenView(
          token.id(),
          token.name(),
          token.owner(),
          token.role(),
          token.created(),
          token.expires(),
          token.lastUsed().orElse(null));
    }
  }

  @Schema(name = "TokenWithSecret")
  record TokenWithSecret(
      TokenView token,
      @Schema(description = "for 'Authorization: Bearer'; shown only once, not stored")
          String secret) {}

  @GetMapping
  @Operation(operationId = "listTokens", summary = "Lists your tokens, newest first")
  Listing<TokenView> list(
      @Schema(description = "list the tokens of all users; administrators only")
          @RequestParam(defaultValue = "false")
          boolean all,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    PageRequest pageRequest = Listing.request(page, size, Sort.unsorted());
    Caller caller = Caller.current();
    if (all && caller.role() != Role.ADMINISTRATOR) {
      throw RequestException.forbidden("Only administrators can list the tokens of other users.");
    }
    @Nullable String owner = all ? null : String.valueOf(caller.personId());
    return new Listing<>(
        tokens.list(owner, pageRequest).stream().map(TokenView::of).toList(),
        page,
        size,
        tokens.count(owner));
  }

  @PostMapping
  @Operation(
      operationId = "createToken",
      summary = "Creates a token",
      description = "Requires a session: a token cannot create tokens that outlive it.")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<TokenWithSecret> create(@RequestBody TokenRequest request) {
    Caller caller = Caller.current();
    if (caller.kind() != Caller.Kind.PERSON || caller.personId() == null) {
      throw RequestException.forbidden("Sign in to create a token; a token cannot create others.");
    }
    if (request.name() == null || request.role() == null) {
      throw RequestException.malformed("name, role and days must be given.");
    }
    if (request.days() < 1 || request.days() > MAX_DAYS) {
      throw RequestException.malformed("days: must be 1 to " + MAX_DAYS + ".");
    }
    if (!caller.role().includes(request.role())) {
      throw RequestException.forbidden(
          "role: must be at most your own role, " + caller.role() + ".");
    }
    ApiTokens.WithSecret created =
        tokens.create(
            caller.personId(), request.name(), request.role(), Duration.ofDays(request.days()));
    return ResponseEntity.created(URI.create("/api/v1/tokens/" + created.token().id()))
        .body(new TokenWithSecret(TokenView.of(created.token()), created.secret()));
  }

  @DeleteMapping("/{id}")
  @Operation(
      operationId = "revokeToken",
      summary = "Revokes a token",
      description = "Administrators can revoke the tokens of all users.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void revoke(@PathVariable String id) {
    Caller caller = Caller.current();
    ApiToken token = tokens.find(id);
    if (caller.role() != Role.ADMINISTRATOR && !token.ownerId().equals(caller.personId())) {
      throw RequestException.notFound("token", id);
    }
    tokens.revoke(id);
  }
}
