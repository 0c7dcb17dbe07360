package org.sitaf.server.storage;

import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.util.Set;
import org.springframework.context.annotation.Configuration;
import org.springframework.web.servlet.HandlerInterceptor;
import org.springframework.web.servlet.config.annotation.InterceptorRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;

/**
 * Refuses requests that bring new work while there is too little room for it. Looking, cancelling,
 * deleting and signing in go on.
 */
@Configuration(proxyBeanMethods = false)
class NewWork implements WebMvcConfigurer, HandlerInterceptor {
  private static final Set<String> BRINGING = Set.of("POST", "PUT", "PATCH");

  private final DiskSpace disk;

  NewWork(DiskSpace disk) {
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
    if (BRINGING.contains(request.getMethod())) {
      disk.requireForNewWork();
    }
    return true;
  }
}
