package org.sitaf.server.web;

import org.springframework.context.annotation.Configuration;
import org.springframework.web.servlet.config.annotation.ViewControllerRegistry;
import org.springframework.web.servlet.config.annotation.WebMvcConfigurer;

/**
 * The portal's files lie in its jar, below META-INF/resources. Its addresses are its own: each of
 * them opens the one page.
 */
@Configuration(proxyBeanMethods = false)
class Portal implements WebMvcConfigurer {
  private static final String PAGE = "forward:/index.html";

  /** A first segment without a dot that is no address of the server. */
  private static final String ROUTE = "/{first:(?!api$|v3$|actuator$)[^.]+}";

  @Override
  public void addViewControllers(ViewControllerRegistry registry) {
    registry.addViewController("/").setViewName(PAGE);
    registry.addViewController(ROUTE).setViewName(PAGE);
    registry.addViewController(ROUTE + "/{*rest}").setViewName(PAGE);
  }
}
