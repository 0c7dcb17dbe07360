package org.sitaf.server.access.token;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Denial;
import org.sitaf.server.access.Role;
import org.sitaf.server.refusal.Refusal;
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
  private static final int MOST_DAYS = 366;

  private final ApiTokens tokens;

  TokenController(ApiTokens tokens) {
    this.tokens = tokens;
  }

  @Schema(name = "TokenRequest")
  record TokenRequest(
      @Schema(description = "what it is for") String name,
      @Schema(description = "what it may do at most; not above your own") Role role,
      @Schema(description = "how long it is valid, 1 to 366 days") int days) {}

  @Schema(name = "Token")
  record TokenView(
      String id,
      String name,
      @Schema(description = "whose it is") String owner,
      Role role,
      Instant created,
      Instant expires,
      @Schema(description = "to the minute; absent when never") @Nullable Instant lastUsed) {
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
      @Schema(description = "for 'Authorization: Bearer'; shown this once, stored nowhere")
          String secret) {}

  @GetMapping
  @Operation(operationId = "listTokens", summary = "Your tokens, the newest first")
  Listing<TokenView> list(
      @Schema(description = "everybody's; for administrators") @RequestParam(defaultValue = "false")
          boolean all,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    PageRequest wanted = Listing.request(page, size, Sort.unsorted());
    Caller caller = Caller.current();
    if (all && caller.role() != Role.ADMINISTRATOR) {
      throw Denial.forbidden("Only administrators see the tokens of others.");
    }
    @Nullable String owner = all ? null : String.valueOf(caller.personId());
    return new Listing<>(
        tokens.list(owner, wanted).stream().map(TokenView::of).toList(),
        page,
        size,
        tokens.count(owner));
  }

  @PostMapping
  @Operation(
      operationId = "createToken",
      summary = "Makes a token of yours",
      description = "For people in a session only: a token cannot make others that outlive it.")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<TokenWithSecret> create(@RequestBody TokenRequest request) {
    Caller caller = Caller.current();
    if (caller.kind() != Caller.Kind.PERSON || caller.personId() == null) {
      throw Denial.forbidden("Tokens are made by people who are signed in, not by tokens.");
    }
    if (request.name() == null || request.role() == null) {
      throw Refusal.malformed("name, role and days must be given.");
    }
    if (request.days() < 1 || request.days() > MOST_DAYS) {
      throw Refusal.malformed("days: 1 to " + MOST_DAYS + ".");
    }
    if (!caller.role().includes(request.role())) {
      throw Denial.forbidden("A token may not do more than you: " + caller.role() + ".");
    }
    ApiTokens.WithSecret made =
        tokens.create(
            caller.personId(), request.name(), request.role(), Duration.ofDays(request.days()));
    return ResponseEntity.created(URI.create("/api/v1/tokens/" + made.token().id()))
        .body(new TokenWithSecret(TokenView.of(made.token()), made.secret()));
  }

  @DeleteMapping("/{id}")
  @Operation(
      operationId = "revokeToken",
      summary = "Revokes a token",
      description = "Your own; administrators anybody's.")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void revoke(@PathVariable String id) {
    Caller caller = Caller.current();
    ApiToken token = tokens.find(id);
    if (caller.role() != Role.ADMINISTRATOR && !token.ownerId().equals(caller.personId())) {
      throw Refusal.notFound("token", id);
    }
    tokens.revoke(id);
  }
}
