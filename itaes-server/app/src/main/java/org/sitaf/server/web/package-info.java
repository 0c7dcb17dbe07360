/**
 * What all of the HTTP interface shares: errors, pages, protection, the portal's files, the OpenAPI
 * document.
 */
@NullMarked
package org.sitaf.server.web;

import org.jspecify.annotations.NullMarked;
