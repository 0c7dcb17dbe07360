package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.ArrayList;
import java.util.List;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;

/** The tags of an activity, by which lists are filtered. They do not belong to its files. */
@Schema(name = "ActivityTags")
record Tags(
    @Schema(
            description =
                "at most 20, each of at most 50 letters, digits, '.', '_', '/' and '-'; a tag such"
                    + " as arm/left is like a folder")
        @Nullable List<@Nullable String> tags) {
  private static final int MAX_TAGS = 20;
  private static final int MAX_LENGTH = 50;
  private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}._/-]+");

  Tags {
    tags = tags == null ? null : new ArrayList<>(tags);
  }

  /**
   * The tags without duplicates.
   *
   * @throws RequestException if one is no tag, or there are too many
   */
  SortedSet<String> requireValid() {
    if (tags == null) {
      throw RequestException.malformed("tags must be given; an empty list removes all.");
    }
    SortedSet<String> valid = new TreeSet<>();
    for (String tag : tags) {
      if (tag == null || tag.length() > MAX_LENGTH || !NAME.matcher(tag).matches()) {
        throw RequestException.malformed(
            "tags: '%s' must have 1 to %d letters, digits, '.', '_', '/' and '-'."
                .formatted(tag, MAX_LENGTH));
      }
      valid.add(tag);
    }
    if (valid.size() > MAX_TAGS) {
      throw RequestException.malformed(
          "tags: an activity has at most %d, not %d.".formatted(MAX_TAGS, valid.size()));
    }
    return valid;
  }

  /** A tag, and how many activities have it. */
  @Schema(name = "Tag")
  record Use(String name, long activities) {}
}
