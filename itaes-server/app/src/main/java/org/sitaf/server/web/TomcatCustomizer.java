package org.sitaf.server.web;

import org.springframework.boot.tomcat.servlet.TomcatServletWebServerFactory;
import org.springframework.boot.web.server.WebServerFactoryCustomizer;
import org.springframework.stereotype.Component;

/** Configures what Tomcat has no Spring property for. */
@Component
class TomcatCustomizer implements WebServerFactoryCustomizer<TomcatServletWebServerFactory> {
  @Override
  public void customize(TomcatServletWebServerFactory factory) {
    // The server accepts no forms. Otherwise Tomcat would read their bodies without our deadlines.
    factory.addConnectorCustomizers(connector -> connector.setParseBodyMethods(""));
  }
}
