package org.sitaf.server.webhook;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.net.URI;
import java.time.Instant;
import java.util.EnumSet;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.access.Caller;
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
@RequestMapping("/api/v1/webhooks")
@Tag(name = "webhooks")
class WebhookController {
  private static final int MAX_NAME = 200;

  private final Webhooks webhooks;
  private final Deliveries deliveries;

  WebhookController(Webhooks webhooks, Deliveries deliveries) {
    this.webhooks = webhooks;
    this.deliveries = deliveries;
  }

  @Schema(name = "WebhookRequest")
  record WebhookRequest(
      @Schema(description = "its host must be in sitaf.webhooks.allowed-hosts") String url,
      @Schema(description = "only builds and commits of activities of this name; absent for all")
          @Nullable String activity,
      @Schema(description = "what is reported; absent for all events")
          @Nullable Set<WebhookEvent> events) {}

  @Schema(name = "Webhook")
  record WebhookView(
      String id,
      URI url,
      @Nullable String activity,
      Set<WebhookEvent> events,
      Instant created,
      String createdBy) {
    static WebhookView of(Webhook webhook) {
      return new WebhookView(
          webhook.id(),
          webhook.url(),
          webhook.activity().orElse(null),
          webhook.events(),
          webhook.created(),
          webhook.createdBy());
    }
  }

  @Schema(name = "WebhookWithSecret")
  record WebhookWithSecret(
      WebhookView webhook,
      @Schema(
              description =
                  "signs the messages: Sitaf-Signature is t=SECONDS,v1=HEX with the HMAC-SHA-256 of"
                      + " SECONDS.BODY; shown only once")
          String secret) {}

  @Schema(name = "WebhookDelivery")
  record DeliveryView(
      String id,
      WebhookEvent event,
      @Schema(description = "absent if a commit is reported") @Nullable String buildId,
      @Schema(description = "id of the commit in Git; absent if a build is reported")
          @Nullable String commit,
      Delivery.State state,
      int tries,
      @Schema(description = "time of the next try; absent if there is none") @Nullable Instant due,
      Instant created,
      @Schema(description = "HTTP status or error of the last try") @Nullable String lastAnswer) {
    static DeliveryView of(Delivery delivery) {
      return new DeliveryView(
          delivery.id(),
          delivery.event(),
          delivery.buildIdOrNull(),
          delivery.commitOrNull(),
          delivery.state(),
          delivery.tries(),
          delivery.state() == Delivery.State.WAITING ? delivery.due() : null,
          delivery.created(),
          delivery.lastAnswer().orElse(null));
    }
  }

  @GetMapping
  @Operation(operationId = "listWebhooks", summary = "Lists webhooks, newest first")
  Listing<WebhookView> list(
      @RequestParam(defaultValue = "0") int page, @RequestParam(defaultValue = "50") int size) {
    PageRequest pageRequest = Listing.request(page, size, Sort.unsorted());
    return new Listing<>(
        webhooks.list(pageRequest).stream().map(WebhookView::of).toList(),
        page,
        size,
        webhooks.count());
  }

  @PostMapping
  @Operation(
      operationId = "createWebhook",
      summary = "Creates a webhook, which is called when a build or a commit ends",
      description =
          "The server sends a POST request with JSON. build.finished: event, build, activity,"
              + " model, state, finished, counts, passed. commit.started and commit.finished:"
              + " event, activity, activityId, commit, subject, author, branch, request, result"
              + " (pending, success, failure or error), description, url; commit.finished has"
              + " models and comment as well: Markdown with the groups of differences. A message"
              + " is sent at least once; its header Sitaf-Delivery is the same each time.")
  @ResponseStatus(HttpStatus.CREATED)
  ResponseEntity<WebhookWithSecret> create(@RequestBody WebhookRequest request) {
    if (request.url() == null) {
      throw RequestException.malformed("url must be given.");
    }
    if (request.activity() != null && request.activity().length() > MAX_NAME) {
      throw RequestException.malformed("activity: must be at most " + MAX_NAME + " characters.");
    }
    Set<WebhookEvent> events =
        request.events() == null ? EnumSet.allOf(WebhookEvent.class) : request.events();
    if (events.isEmpty()) {
      throw RequestException.malformed("events: must name at least one event, or be absent.");
    }
    Webhooks.WithSecret created =
        webhooks.create(request.url(), request.activity(), events, Caller.currentName());
    return ResponseEntity.created(URI.create("/api/v1/webhooks/" + created.webhook().id()))
        .body(new WebhookWithSecret(WebhookView.of(created.webhook()), created.secret()));
  }

  @DeleteMapping("/{id}")
  @Operation(operationId = "deleteWebhook", summary = "Deletes a webhook")
  @ResponseStatus(HttpStatus.NO_CONTENT)
  void delete(@PathVariable String id) {
    webhooks.delete(id);
  }

  @GetMapping("/{id}/deliveries")
  @Operation(
      operationId = "listWebhookDeliveries",
      summary = "Lists the deliveries of a webhook, newest first")
  Listing<DeliveryView> deliveries(
      @PathVariable String id,
      @RequestParam(defaultValue = "0") int page,
      @RequestParam(defaultValue = "50") int size) {
    PageRequest pageRequest = Listing.request(page, size, Sort.unsorted());
    webhooks.find(id);
    return new Listing<>(
        deliveries.list(id, pageRequest).stream().map(DeliveryView::of).toList(),
        page,
        size,
        deliveries.count(id));
  }
}
