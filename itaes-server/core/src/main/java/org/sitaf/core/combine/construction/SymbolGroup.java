package org.sitaf.core.combine.construction;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A permutation group of the values {@code 0 .. v-1}.
 *
 * @param name name for debugging
 * @param elements permutations, including the identity
 */
@SuppressWarnings("ArrayRecordComponent") // internal
record SymbolGroup(String name, int[][] elements) {

  /** The groups to try for {@code v} values, in descending order of size. */
  static List<SymbolGroup> of(int v) {
    List<SymbolGroup> groups = new ArrayList<>();
    GaloisField.of(v - 1).ifPresent(field -> groups.addAll(projective(field)));
    GaloisField.of(v).ifPresent(field -> groups.addAll(affine(field, v)));
    if (v > 2) {
      GaloisField.of(v - 1).ifPresent(field -> groups.addAll(affine(field, v)));
    }
    for (int n = 2; n <= v; n++) {
      for (int blocks = 1; n * blocks <= v; blocks++) {
        if (2 * n * blocks >= v) {
          groups.add(cyclic(n, blocks, v));
        }
      }
    }
    groups.sort((a, b) -> b.elements.length - a.elements.length);
    return groups;
  }

  int order() {
    return elements.length;
  }

  /**
   * The sets of constant rows to try in addition to starter rows: none, those of fixed values, all.
   */
  List<List<Integer>> constantRows() {
    List<Integer> all = new ArrayList<>();
    List<Integer> fixed = new ArrayList<>();
    for (int x = 0; x < elements[0].length; x++) {
      int value = x;
      all.add(x);
      if (Arrays.stream(elements).allMatch(map -> map[value] == value)) {
        fixed.add(x);
      }
    }
    return List.of(List.<Integer>of(), fixed, all).stream().distinct().toList();
  }

  /** Rotates consecutive blocks of {@code n} values; the remaining values are fixed. */
  private static SymbolGroup cyclic(int n, int blocks, int v) {
    int[][] elements = new int[n][v];
    for (int shift = 0; shift < n; shift++) {
      for (int x = 0; x < v; x++) {
        elements[shift][x] = x < n * blocks ? x / n * n + (x % n + shift) % n : x;
      }
    }
    return new SymbolGroup("Z" + n + "x" + blocks, elements);
  }

  /** The maps {@code x -> ax + b} with {@code a} in a subgroup, for every subgroup. */
  private static List<SymbolGroup> affine(GaloisField field, int v) {
    int q = field.order();
    List<SymbolGroup> groups = new ArrayList<>();
    int generator = generator(field);
    for (int index = 1; index < q; index++) {
      if ((q - 1) % index != 0) {
        continue;
      }
      int step = power(field, generator, index);
      List<int[]> elements = new ArrayList<>();
      int a = 1;
      do {
        for (int b = 0; b < q; b++) {
          int[] map = new int[v];
          for (int x = 0; x < v; x++) {
            map[x] = x < q ? field.add(field.multiply(a, x), b) : x;
          }
          elements.add(map);
        }
        a = field.multiply(a, step);
      } while (a != 1);
      groups.add(new SymbolGroup("A" + q + "/" + index, elements.toArray(int[][]::new)));
    }
    return groups;
  }

  /** PGL(2, q) on the {@code q + 1} points of the line, and PSL(2, q) for odd q. */
  private static List<SymbolGroup> projective(GaloisField field) {
    int q = field.order();
    List<int[]> all = new ArrayList<>();
    List<int[]> special = new ArrayList<>();
    for (int code = 0; code < q * q * q * q; code++) {
      int a = code % q;
      int b = code / q % q;
      int c = code / q / q % q;
      int d = code / q / q / q;
      int determinant = field.subtract(field.multiply(a, d), field.multiply(b, c));
      boolean normal = c == 1 || (c == 0 && d == 1);
      if (!normal || determinant == 0) {
        continue;
      }
      int[] map = new int[q + 1];
      for (int x = 0; x < q; x++) {
        int over = field.add(field.multiply(a, x), b);
        int under = field.add(field.multiply(c, x), d);
        map[x] = under == 0 ? q : field.multiply(over, field.inverse(under));
      }
      map[q] = c == 0 ? q : field.multiply(a, field.inverse(c));
      all.add(map);
      if (field.isSquare(determinant)) {
        special.add(map);
      }
    }
    List<SymbolGroup> groups = new ArrayList<>();
    groups.add(new SymbolGroup("PGL" + q, all.toArray(int[][]::new)));
    if (special.size() < all.size()) {
      groups.add(new SymbolGroup("PSL" + q, special.toArray(int[][]::new)));
    }
    return groups;
  }

  private static int generator(GaloisField field) {
    for (int g = 1; g < field.order(); g++) {
      int n = 1;
      for (int x = g; x != 1; x = field.multiply(x, g)) {
        n++;
      }
      if (n == field.order() - 1) {
        return g;
      }
    }
    throw new IllegalStateException("not a field: no generator");
  }

  private static int power(GaloisField field, int base, int exponent) {
    int power = 1;
    for (int i = 0; i < exponent; i++) {
      power = field.multiply(power, base);
    }
    return power;
  }

  /** Numbers the orbits of the group on tuples. A tuple is encoded as a number in base v. */
  int[] orbits(int strength) {
    int v = elements[0].length;
    int size = 1;
    for (int i = 0; i < strength; i++) {
      size *= v;
    }
    int[] orbit = new int[size];
    Arrays.fill(orbit, -1);
    int next = 0;
    for (int tuple = 0; tuple < size; tuple++) {
      if (orbit[tuple] >= 0) {
        continue;
      }
      for (int[] map : elements) {
        int image = 0;
        for (int i = 0, rest = tuple, place = 1; i < strength; i++, rest /= v, place *= v) {
          image += map[rest % v] * place;
        }
        orbit[image] = next;
      }
      next++;
    }
    return orbit;
  }
}
