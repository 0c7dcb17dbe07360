package org.sitaf.server.web;

import java.io.IOException;
import java.time.Duration;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.springframework.context.annotation.Configuration;
import org.springframework.core.io.Resource;
import org.springframework.http.CacheControl;
import org.springframework.web.servlet.config.annotation.ResourceHandlerRegistry;
import org.springframework.web.servlet.config.annotation.ViewControllerRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;
import org.springframework.web.servlet.resource.PathResourceResolver;

/**
 * The portal's files, which lie in its jar. The portal has addresses of its own, such as {@code
 * /builds/ID}: whatever has no dot and is no address of the server opens its one page.
 */
@Configuration(proxyBeanMethods = false)
class Portal implements WebMvcConfigurer {
  private static final String FILES = "classpath:/META-INF/resources/";
  private static final String PAGE = "index.html";

  @Override
  public void addViewControllers(ViewControllerRegistry registry) {
    registry.addViewController("/").setViewName("forward:/" + PAGE);
  }

  @Override
  public void addResourceHandlers(ResourceHandlerRegistry registry) {
    // The names of these hold a digest of their content.
    registry
        .addResourceHandler("/assets/**")
        .addResourceLocations(FILES + "assets/")
        .setCacheControl(CacheControl.maxAge(Duration.ofDays(365)).cachePublic().immutable());
    registry
        .addResourceHandler("/**")
        .addResourceLocations(FILES)
        .setCacheControl(CacheControl.noCache())
        .resourceChain(false)
        .addResolver(new PageForRoutes());
  }

  private static final class PageForRoutes extends PathResourceResolver {
    @Override
    protected @Nullable Resource getResource(String path, Resource location) throws IOException {
      Resource file = super.getResource(path, location);
      boolean ofServer = Stream.of("api/", "v3/", "actuator/").anyMatch((path + "/")::startsWith);
      return file != null || ofServer || path.indexOf('.') >= 0
          ? file
          : super.getResource(PAGE, location);
    }
  }
}
