package org.sitaf.server;

import java.time.Clock;
import org.sitaf.server.settings.LimitSettings;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.boot.SpringApplication;
import org.springframework.boot.autoconfigure.SpringBootApplication;
import org.springframework.boot.context.properties.EnableConfigurationProperties;
import org.springframework.context.annotation.Bean;

/** Starts the server. */
@SpringBootApplication
@EnableConfigurationProperties({SitafSettings.class, LimitSettings.class})
public class SitafServer {

  /** Arguments are Spring properties, such as {@code --server.port=0}. */
  public static void main(String[] arguments) {
    SpringApplication.run(SitafServer.class, arguments);
  }

  @Bean
  Clock clock() {
    return Clock.systemUTC();
  }
}
