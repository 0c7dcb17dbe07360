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
import org.springframework.web.servlet.resource.EncodedResourceResolver;
import org.springframework.web.servlet.resource.PathResourceResolver;

/**
 * Serves the portal's files from its jar. The portal is a single-page application: paths such as
 * {@code /builds/ID}, which contain no dot and do not belong to the server, return index.html.
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
    // File names contain a hash of the content.
    registry
        .addResourceHandler("/assets/**")
        .addResourceLocations(FILES + "assets/")
        .setCacheControl(CacheControl.maxAge(Duration.ofDays(365)).cachePublic().immutable())
        .resourceChain(true)
        // The build of the portal has compressed them.
        .addResolver(new EncodedResourceResolver());
    registry
        .addResourceHandler("/**")
        .addResourceLocations(FILES)
        .setCacheControl(CacheControl.noCache())
        .resourceChain(false)
        .addResolver(new RouteResolver());
  }

  private static final class RouteResolver extends PathResourceResolver {
    @Override
    protected @Nullable Resource getResource(String path, Resource location) throws IOException {
      Resource file = super.getResource(path, location);
      boolean belongsToServer =
          Stream.of("api/", "v3/", "actuator/").anyMatch((path + "/")::startsWith);
      return file != null || belongsToServer || path.indexOf('.') >= 0
          ? file
          : super.getResource(PAGE, location);
    }
  }
}
