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
 * Access rules: requests that match no rule are denied. The portal's static files contain no user
 * data and are public, because the sign-in page is one of them.
 */
@Configuration(proxyBeanMethods = false)
@EnableConfigurationProperties(AccessSettings.class)
class SecurityConfiguration {
  private static final String SESSION = "/api/v1/session";

  /** Messages of forges, which carry a signature. */
  private static final String GIT_HOOKS = "/api/v1/git-hooks/**";

  private static final String VIEWER = "VIEWER";
  private static final String TESTER = "TESTER";
  private static final String ADMINISTRATOR = "ADMINISTRATOR";

  @Bean
  SecurityFilterChain securityFilters(HttpSecurity http, ApiTokens tokens, Audit audit)
      throws Exception {
    return http.authorizeHttpRequests(SecurityConfiguration::rules)
        // Browsers send cookies by themselves, but not tokens: only sessions need CSRF protection.
        .csrf(
            csrf ->
                csrf.spa()
                    .ignoringRequestMatchers(BearerFilter::hasToken)
                    .ignoringRequestMatchers(GIT_HOOKS))
        .addFilterBefore(new BearerFilter(tokens), AnonymousAuthenticationFilter.class)
        .exceptionHandling(
            handlers ->
                handlers
                    .authenticationEntryPoint(SecurityConfiguration::unauthenticated)
                    .accessDeniedHandler(
                        (request, response, e) -> deny(audit, request, response, e)))
        .sessionManagement(sessions -> sessions.sessionCreationPolicy(SessionCreationPolicy.NEVER))
        .requestCache(AbstractHttpConfigurer::disable)
        .formLogin(AbstractHttpConfigurer::disable)
        .httpBasic(AbstractHttpConfigurer::disable)
        .logout(AbstractHttpConfigurer::disable)
        // HostFilter sets the headers, also for responses that do not reach this chain.
        .headers(AbstractHttpConfigurer::disable)
        .build();
  }

  private static void rules(
      AuthorizeHttpRequestsConfigurer<HttpSecurity>.AuthorizationManagerRequestMatcherRegistry
          rules) {
    rules
        // Continuations of requests that were authorized before.
        .dispatcherTypeMatchers(DispatcherType.ASYNC, DispatcherType.ERROR, DispatcherType.FORWARD)
        .permitAll()
        .requestMatchers("/actuator/health")
        .permitAll()
        // Its labels reveal the paths of the server's folders and the load.
        .requestMatchers("/actuator/prometheus")
        .hasRole(VIEWER)
        .requestMatchers(HttpMethod.POST, SESSION)
        .permitAll()
        .requestMatchers(HttpMethod.POST, GIT_HOOKS)
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

  private static void unauthenticated(
      HttpServletRequest request, HttpServletResponse response, AuthenticationException e)
      throws IOException {
    requireSignIn(response);
  }

  private static void requireSignIn(HttpServletResponse response) throws IOException {
    // Without a WWW-Authenticate header, which would open the browser's password dialog.
    ProblemResponse.write(
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
    boolean isSignIn =
        request.getMethod().equals("POST") && request.getRequestURI().equals(SESSION);
    if (e instanceof CsrfException && !Caller.isKnown() && !isSignIn) {
      requireSignIn(response);
      return;
    }
    if (e instanceof CsrfException) {
      ProblemResponse.write(
          response,
          HttpStatus.FORBIDDEN,
          "Not allowed",
          "Send the value of the cookie XSRF-TOKEN in the header X-XSRF-TOKEN.");
      return;
    }
    audit.recordRejected(
        Caller.currentName(),
        "denied",
        request.getMethod() + " " + request.getRequestURI(),
        "refused: 403",
        request.getRemoteAddr());
    ProblemResponse.write(
        response, HttpStatus.FORBIDDEN, "Not allowed", "Your role does not allow this.");
  }
}
