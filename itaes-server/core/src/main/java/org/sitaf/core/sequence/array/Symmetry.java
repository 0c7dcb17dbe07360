package org.sitaf.core.sequence.array;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A group that acts on words: cycles of the letters, and reversal. A search for words of which all
 * images are used is smaller by the size of the group.
 *
 * @param images each image as a permutation of the letters; the first is the identity
 * @param reversal whether each image is also read backwards
 */
record Symmetry(List<int[]> images, boolean reversal) {
  /** Cycles of one length over the letters; letters that are left over are fixed. */
  static Symmetry cyclic(int letters, int cycle, boolean reversal) {
    List<int[]> images = new ArrayList<>();
    int moved = letters / cycle * cycle;
    for (int shift = 0; shift < cycle; shift++) {
      int[] image = new int[letters];
      for (int i = 0; i < letters; i++) {
        image[i] = i >= moved ? i : i / cycle * cycle + (i % cycle + shift) % cycle;
      }
      images.add(image);
    }
    return new Symmetry(images, reversal);
  }

  /** The number of words that a word stands for. */
  int order() {
    return images.size() * (reversal ? 2 : 1);
  }

  /** All words that a word stands for. */
  List<int[]> orbit(int[] word) {
    List<int[]> orbit = new ArrayList<>();
    for (int[] image : images) {
      int[] mapped =
          Arrays.stream(word).map(letter -> letter < 0 ? letter : image[letter]).toArray();
      orbit.add(mapped);
      if (reversal) {
        int[] reversed = new int[mapped.length];
        for (int i = 0; i < mapped.length; i++) {
          reversed[i] = mapped[mapped.length - 1 - i];
        }
        orbit.add(reversed);
      }
    }
    return orbit;
  }

  /** The smallest tuple of each tuple's orbit. */
  int[] classes(TupleSpace space) {
    int[] classOf = new int[space.size()];
    Arrays.fill(classOf, -1);
    for (int tuple = 0; tuple < classOf.length; tuple++) {
      if (classOf[tuple] < 0) {
        for (int[] image : orbit(space.letters(tuple))) {
          classOf[space.index(image)] = tuple;
        }
      }
    }
    return classOf;
  }
}
