package org.sitaf.core.combine.construction;

import java.util.Optional;

/** The finite field with {@code q} elements, represented as the numbers {@code 0 .. q-1}. */
final class GaloisField {
  private final int order;
  private final int[][] sum;
  private final int[][] product;

  private GaloisField(int prime, int degree) {
    int q = 1;
    for (int i = 0; i < degree; i++) {
      q *= prime;
    }
    this.order = q;
    this.sum = new int[q][q];
    this.product = new int[q][q];
    int[] modulus = modulus(prime, degree);
    for (int a = 0; a < q; a++) {
      for (int b = 0; b < q; b++) {
        sum[a][b] = add(a, b, prime);
        product[a][b] = multiply(a, b, prime, degree, modulus);
      }
    }
  }

  /** The field of an order; empty if the order is not a prime power. */
  static Optional<GaloisField> of(int order) {
    for (int p = 2; p <= order; p++) {
      if (order % p == 0) {
        int degree = 0;
        int rest = order;
        while (rest % p == 0) {
          rest /= p;
          degree++;
        }
        return rest == 1 ? Optional.of(new GaloisField(p, degree)) : Optional.empty();
      }
    }
    return Optional.empty();
  }

  /** The smallest order of a field that is at least {@code least}. */
  static int orderFrom(int least) {
    int q = Math.max(2, least);
    while (!isPrimePower(q)) {
      q++;
    }
    return q;
  }

  private static boolean isPrimePower(int q) {
    int p = 2;
    while (q % p != 0) {
      p++;
    }
    int rest = q;
    while (rest % p == 0) {
      rest /= p;
    }
    return rest == 1;
  }

  int order() {
    return order;
  }

  int add(int a, int b) {
    return sum[a][b];
  }

  int multiply(int a, int b) {
    return product[a][b];
  }

  int subtract(int a, int b) {
    for (int x = 0; x < order; x++) {
      if (sum[x][b] == a) {
        return x;
      }
    }
    throw new IllegalStateException("not a field: missing difference");
  }

  /** The multiplicative inverse of an element other than zero. */
  int inverse(int a) {
    for (int x = 1; x < order; x++) {
      if (product[x][a] == 1) {
        return x;
      }
    }
    throw new ArithmeticException("zero has no inverse");
  }

  boolean isSquare(int a) {
    for (int x = 0; x < order; x++) {
      if (product[x][x] == a) {
        return true;
      }
    }
    return false;
  }

  /**
   * Adds two elements. Elements are polynomials; their coefficients are the digits in base {@code
   * p}.
   */
  private static int add(int a, int b, int p) {
    int result = 0;
    int place = 1;
    for (int x = a, y = b; x > 0 || y > 0; x /= p, y /= p) {
      result += (x % p + y % p) % p * place;
      place *= p;
    }
    return result;
  }

  private static int multiply(int a, int b, int p, int degree, int[] modulus) {
    int[] c = new int[2 * degree];
    int x = a;
    for (int i = 0; i < degree; i++, x /= p) {
      int y = b;
      for (int j = 0; j < degree; j++, y /= p) {
        c[i + j] = (c[i + j] + x % p * (y % p)) % p;
      }
    }
    for (int i = 2 * degree - 1; i >= degree; i--) {
      for (int j = 0; j < degree; j++) {
        c[i - degree + j] = (c[i - degree + j] + c[i] * (p - modulus[j])) % p;
      }
      c[i] = 0;
    }
    int result = 0;
    for (int i = degree - 1; i >= 0; i--) {
      result = result * p + c[i];
    }
    return result;
  }

  /** The first monic irreducible polynomial of a degree, found by trial. */
  private static int[] modulus(int p, int degree) {
    int q = (int) Math.round(Math.pow(p, degree));
    for (int code = 0; code < q; code++) {
      int[] candidate = new int[degree];
      for (int i = 0, rest = code; i < degree; i++, rest /= p) {
        candidate[i] = rest % p;
      }
      if (degree == 1 || isField(p, degree, q, candidate)) {
        return candidate;
      }
    }
    throw new IllegalStateException("no irreducible polynomial of degree " + degree);
  }

  private static boolean isField(int p, int degree, int q, int[] modulus) {
    for (int a = 1; a < q; a++) {
      for (int b = a; b < q; b++) {
        if (multiply(a, b, p, degree, modulus) == 0) {
          return false;
        }
      }
    }
    return true;
  }
}
