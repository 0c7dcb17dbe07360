package org.sitaf.server.access.web;

import jakarta.servlet.DispatcherType;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.token.ApiTokens;
import org.sitaf.server.audit.Audit;
import org.springframework.boot.context.properties.EnableConfigurationProperties;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.http.HttpMethod;
import org.springframework.http.HttpStatus;
import org.springframework.security.access.AccessDeniedException;
import org.springframework.security.config.annotation.web.builders.HttpSecurity;
import org.springframework.security.config.annotation.web.configurers.AbstractHttpConfigurer;
import org.springframework.security.config.annotation.web.configurers.AuthorizeHttpRequestsConfigurer;
import org.springframework.security.config.http.SessionCreationPolicy;
import org.springframework.security.core.AuthenticationException;
import org.springframework.security.web.SecurityFilterChain;
import org.springframework.security.web.authentication.AnonymousAuthenticationFilter;
import org.springframework.security.web.csrf.CsrfException;

/**
 * Which requests are let through: what is not named here is refused. The portal's own files hold
 * nothing of anybody and are open, or nobody could sign in.
 */
@Configuration(proxyBeanMethods = false)
@EnableConfigurationProperties(AccessSettings.class)
class SecurityConfiguration {
  private static final String SESSION = "/api/v1/session";
  private static final String VIEWER = "VIEWER";
  private static final String TESTER = "TESTER";
  private static final String ADMINISTRATOR = "ADMINISTRATOR";

  @Bean
  SecurityFilterChain securityFilters(HttpSecurity http, ApiTokens tokens, Audit audit)
      throws Exception {
    return http.authorizeHttpRequests(SecurityConfiguration::rules)
        // What a browser sends by itself is not enough to change anything; tokens it never sends.
        .csrf(csrf -> csrf.spa().ignoringRequestMatchers(BearerFilter::hasToken))
        .addFilterBefore(new BearerFilter(tokens), AnonymousAuthenticationFilter.class)
        .exceptionHandling(
            refusals ->
                refusals
                    .authenticationEntryPoint(SecurityConfiguration::unknown)
                    .accessDeniedHandler(
                        (request, response, e) -> deny(audit, request, response, e)))
        .sessionManagement(sessions -> sessions.sessionCreationPolicy(SessionCreationPolicy.NEVER))
        .requestCache(AbstractHttpConfigurer::disable)
        .formLogin(AbstractHttpConfigurer::disable)
        .httpBasic(AbstractHttpConfigurer::disable)
        .logout(AbstractHttpConfigurer::disable)
        // Those of the guard hold for answers that come before this, too.
        .headers(AbstractHttpConfigurer::disable)
        .build();
  }

  private static void rules(
      AuthorizeHttpRequestsConfigurer<HttpSecurity>.AuthorizationManagerRequestMatcherRegistry
          rules) {
    rules
        // Parts of requests that were let through before.
        .dispatcherTypeMatchers(DispatcherType.ASYNC, DispatcherType.ERROR, DispatcherType.FORWARD)
        .permitAll()
        .requestMatchers("/actuator/health")
        .permitAll()
        // Its labels hold the paths of the server's folders, and how much work there is.
        .requestMatchers("/actuator/prometheus")
        .hasRole(VIEWER)
        .requestMatchers(HttpMethod.POST, SESSION)
        .permitAll()
        .requestMatchers("/api/v1/session/**", "/api/v1/tokens/**")
        .hasRole(VIEWER)
        .requestMatchers("/api/v1/users/**", "/api/v1/audit/**", "/api/v1/enrolments/**")
        .hasRole(ADMINISTRATOR)
        .requestMatchers("/api/v1/webhooks/**")
        .hasRole(ADMINISTRATOR)
        .requestMatchers(HttpMethod.GET, "/api/**", "/v3/**")
        .hasRole(VIEWER)
        .requestMatchers(HttpMethod.HEAD, "/api/**", "/v3/**")
        .hasRole(VIEWER)
        .requestMatchers("/api/v1/agents/**")
        .hasRole(ADMINISTRATOR)
        .requestMatchers("/api/**")
        .hasRole(TESTER)
        .requestMatchers("/v3/**", "/actuator/**")
        .denyAll()
        .requestMatchers(HttpMethod.GET, "/**")
        .permitAll()
        .requestMatchers(HttpMethod.HEAD, "/**")
        .permitAll()
        .anyRequest()
        .denyAll();
  }

  private static void unknown(
      HttpServletRequest request, HttpServletResponse response, AuthenticationException e)
      throws IOException {
    refuseUnknown(response);
  }

  private static void refuseUnknown(HttpServletResponse response) throws IOException {
    // No challenge: a browser would ask for a password in a window of its own.
    Answers.refuse(
        response,
        HttpStatus.UNAUTHORIZED,
        "Not signed in",
        "Sign in, or send a token as 'Authorization: Bearer TOKEN'.");
  }

  private static void deny(
      Audit audit,
      HttpServletRequest request,
      HttpServletResponse response,
      AccessDeniedException e)
      throws IOException {
    boolean signsIn = request.getMethod().equals("POST") && request.getRequestURI().equals(SESSION);
    if (e instanceof CsrfException && !Caller.isKnown() && !signsIn) {
      refuseUnknown(response);
      return;
    }
    if (e instanceof CsrfException) {
      Answers.refuse(
          response,
          HttpStatus.FORBIDDEN,
          "Not allowed",
          "A browser sends the value of the cookie XSRF-TOKEN as the header X-XSRF-TOKEN.");
      return;
    }
    audit.recordRefusal(
        Caller.currentName(),
        "denied",
        request.getMethod() + " " + request.getRequestURI(),
        "refused: 403",
        request.getRemoteAddr());
    Answers.refuse(response, HttpStatus.FORBIDDEN, "Not allowed", "Your role does not allow this.");
  }
}
