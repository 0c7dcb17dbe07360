package org.sitaf.server.quota;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.user.Users;
import org.sitaf.server.error.RequestException;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PutMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.RestController;

@RestController
@RequestMapping("/api/v1")
class UsageController {
  private final Quotas quotas;
  private final Users users;

  UsageController(Quotas quotas, Users users) {
    this.quotas = quotas;
    this.users = users;
  }

  @Schema(name = "Quota")
  record Quota(
      @Schema(description = "limit for the user's files; null for the server's default")
          @Nullable Long mib) {}

  @GetMapping("/session/usage")
  @Tag(name = "session")
  @Operation(operationId = "getUsage", summary = "Returns your usage and limits")
  Usage own() {
    String person = Caller.current().personId();
    if (person == null) {
      throw RequestException.forbidden("The command that started the server has no quota.");
    }
    return quotas.usage(person);
  }

  @GetMapping("/users/{id}/usage")
  @Tag(name = "users")
  @Operation(operationId = "getUsageOfUser", summary = "Returns the usage and limits of a user")
  Usage of(@PathVariable String id) {
    return quotas.usage(users.find(id).id());
  }

  @PutMapping("/users/{id}/quota")
  @Tag(name = "users")
  @Operation(operationId = "setQuota", summary = "Sets the quota of a user")
  Usage set(@PathVariable String id, @RequestBody Quota quota) {
    String person = users.find(id).id();
    quotas.set(person, quota.mib());
    return quotas.usage(person);
  }
}
