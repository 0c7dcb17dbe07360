package org.sitaf.core.sequence.array;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A cyclic group of permutations of the letters. A search for words of which all images are used is
 * smaller by the order of the group.
 *
 * @param images each permutation; the first is the identity
 */
record Symmetry(List<int[]> images) {
  /** Only the identity, for which no letters are needed. */
  static final Symmetry NONE = new Symmetry(List.of(new int[0]));

  /** Cycles of one length over the letters; letters that are left over are fixed. */
  static Symmetry cyclic(int letters, int cycle) {
    List<int[]> images = new ArrayList<>();
    int moved = letters / cycle * cycle;
    for (int shift = 0; shift < cycle; shift++) {
      int[] image = new int[letters];
      for (int i = 0; i < letters; i++) {
        image[i] = i >= moved ? i : i / cycle * cycle + (i % cycle + shift) % cycle;
      }
      images.add(image);
    }
    return new Symmetry(images);
  }

  /** The number of words that a word stands for. */
  int order() {
    return images.size();
  }

  /** All words that a word stands for, itself first. */
  List<int[]> orbit(int[] word) {
    List<int[]> orbit = new ArrayList<>();
    orbit.add(word);
    for (int[] image : images.subList(1, images.size())) {
      orbit.add(Arrays.stream(word).map(letter -> letter < 0 ? letter : image[letter]).toArray());
    }
    return orbit;
  }
}
