package org.sitaf.server.web;

import java.io.IOException;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.springframework.beans.factory.annotation.Value;
import org.springframework.context.annotation.Configuration;
import org.springframework.core.io.ClassPathResource;
import org.springframework.core.io.Resource;
import org.springframework.http.CacheControl;
import org.springframework.web.servlet.config.annotation.ResourceHandlerRegistry;
import org.springframework.web.servlet.config.annotation.ViewControllerRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;
import org.springframework.web.servlet.resource.PathResourceResolver;

/**
 * Serves the book below {@code /docs}. The launcher builds it in the background when the server
 * starts; until then, its pages say so.
 */
@Configuration(proxyBeanMethods = false)
class Documentation implements WebMvcConfigurer {
  static final String PATH = "/docs/";
  private static final String FIRST = PATH + "index.html";

  private final String location;

  /**
   * @param folder {@code sitaf.documentation}: folder of the site; empty for none
   */
  Documentation(@Value("${sitaf.documentation:}") String folder) {
    location =
        folder.isEmpty()
            ? "classpath:/documentation/"
            : Path.of(folder).toAbsolutePath().normalize().toUri() + "/";
  }

  @Override
  public void addViewControllers(ViewControllerRegistry registry) {
    registry.addRedirectViewController("/docs", FIRST);
    registry.addRedirectViewController(PATH, FIRST);
  }

  @Override
  public void addResourceHandlers(ResourceHandlerRegistry registry) {
    registry
        .addResourceHandler(PATH + "**")
        .addResourceLocations(location)
        .setCacheControl(CacheControl.noCache())
        // A built site replaces the page that says that it is missing.
        .resourceChain(false)
        .addResolver(new PageResolver());
  }

  private static final class PageResolver extends PathResourceResolver {
    @Override
    protected @Nullable Resource getResource(String path, Resource folder) throws IOException {
      Resource file = super.getResource(path, folder);
      Resource first = super.getResource("index.html", folder);
      return file == null && first == null && path.endsWith(".html")
          ? new ClassPathResource("documentation/missing.html")
          : file;
    }
  }
}
