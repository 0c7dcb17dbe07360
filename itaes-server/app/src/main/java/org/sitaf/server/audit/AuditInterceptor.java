package org.sitaf.server.audit;

import io.swagger.v3.oas.annotations.Operation;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.security.Principal;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.springframework.context.annotation.Configuration;
import org.springframework.web.method.HandlerMethod;
import org.springframework.web.servlet.HandlerInterceptor;
import org.springframework.web.servlet.config.annotation.InterceptorRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;

/** Records each request that changes or tries to change something in the audit log. */
@Configuration(proxyBeanMethods = false)
class AuditInterceptor implements WebMvcConfigurer, HandlerInterceptor {
  private static final Set<String> SAFE_METHODS = Set.of("GET", "HEAD", "OPTIONS", "TRACE");
  private static final int CLIENT_ERROR = 400;

  private final Audit audit;

  AuditInterceptor(Audit audit) {
    this.audit = audit;
  }

  @Override
  public void addInterceptors(InterceptorRegistry registry) {
    registry.addInterceptor(this).addPathPatterns("/api/**");
  }

  @Override
  public void afterCompletion(
      HttpServletRequest request,
      HttpServletResponse response,
      Object handler,
      @Nullable Exception failure) {
    if (SAFE_METHODS.contains(request.getMethod()) || !(handler instanceof HandlerMethod method)) {
      return;
    }
    Operation operation = method.getMethodAnnotation(Operation.class);
    Principal actor = request.getUserPrincipal();
    int status = response.getStatus();
    String action = operation == null ? method.getMethod().getName() : operation.operationId();
    String subject =
        request.getAttribute(Audit.SUBJECT) instanceof String given
            ? given
            : request.getRequestURI();
    if (status < CLIENT_ERROR) {
      audit.record(
          actor == null ? "-" : actor.getName(), action, subject, "done", request.getRemoteAddr());
    } else {
      audit.recordRejected(
          actor == null ? "-" : actor.getName(),
          action,
          subject,
          "refused: " + status,
          request.getRemoteAddr());
    }
  }
}
