/**
 * Common parts of the HTTP interface: errors, pages, request filters, the portal's files, the
 * OpenAPI document.
 */
@NullMarked
package org.sitaf.server.web;

import org.jspecify.annotations.NullMarked;
