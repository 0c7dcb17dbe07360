package org.sitaf.server.web;

import org.springframework.boot.tomcat.servlet.TomcatServletWebServerFactory;
import org.springframework.boot.web.server.WebServerFactoryCustomizer;
import org.springframework.stereotype.Component;

/** What of Tomcat has no setting. */
@Component
class Connections implements WebServerFactoryCustomizer<TomcatServletWebServerFactory> {
  @Override
  public void customize(TomcatServletWebServerFactory factory) {
    // Nothing takes forms; Tomcat would read them, however slowly they come, in search of
    // parameters.
    factory.addConnectorCustomizers(connector -> connector.setParseBodyMethods(""));
  }
}
