package org.sitaf.server.storage;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Set;
import org.springframework.context.annotation.Configuration;
import org.springframework.web.servlet.HandlerInterceptor;
import org.springframework.web.servlet.config.annotation.InterceptorRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;

/**
 * Rejects requests that add work while the disk is nearly full. Reading, cancelling, deleting and
 * signing in are still possible.
 */
@Configuration(proxyBeanMethods = false)
class NewWorkInterceptor implements WebMvcConfigurer, HandlerInterceptor {
  private static final Set<String> METHODS = Set.of("POST", "PUT", "PATCH");

  private final DiskSpace disk;

  NewWorkInterceptor(DiskSpace disk) {
    this.disk = disk;
  }

  @Override
  public void addInterceptors(InterceptorRegistry registry) {
    registry
        .addInterceptor(this)
        .addPathPatterns(
            "/api/v1/activities/**",
            "/api/v1/builds/**",
            "/api/v1/schedules/**",
            "/api/v1/suites/**")
        .excludePathPatterns(
            "/api/v1/activities/*/model-previews",
            "/api/v1/builds/*/cancel",
            "/api/v1/schedules/preview",
            "/api/v1/schedules/*/pause");
  }

  @Override
  public boolean preHandle(
      HttpServletRequest request, HttpServletResponse response, Object handler) {
    if (METHODS.contains(request.getMethod())) {
      disk.requireForNewWork();
    }
    return true;
  }
}
