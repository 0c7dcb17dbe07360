package org.sitaf.core.combine.coverage;

import java.util.List;
import org.sitaf.core.combine.SeededRandom;

/** Combines several coverages, one per strength. */
final class JointCoverage implements Coverage {
  private final Coverage[] parts;
  private int[] scratch = new int[16];

  JointCoverage(List<Coverage> parts) {
    this.parts = parts.toArray(Coverage[]::new);
  }

  @Override
  public long required() {
    long sum = 0;
    for (Coverage part : parts) {
      sum += part.required();
    }
    return sum;
  }

  @Override
  public int uncovered() {
    int sum = 0;
    for (Coverage part : parts) {
      sum += part.uncovered();
    }
    return sum;
  }

  @Override
  public int gain(Row row, int column, int value) {
    int sum = 0;
    for (Coverage part : parts) {
      sum += part.gain(row, column, value);
    }
    return sum;
  }

  @Override
  public int loss(Row row, int column) {
    int sum = 0;
    for (Coverage part : parts) {
      sum += part.loss(row, column);
    }
    return sum;
  }

  @Override
  public void gains(Row row, int column, int[] out) {
    if (scratch.length < out.length) {
      scratch = new int[out.length];
    }
    java.util.Arrays.fill(out, 0);
    for (Coverage part : parts) {
      java.util.Arrays.fill(scratch, 0);
      part.gains(row, column, scratch);
      for (int v = 0; v < out.length; v++) {
        out[v] += scratch[v];
      }
    }
  }

  @Override
  public void add(Row row) {
    for (Coverage part : parts) {
      part.add(row);
    }
  }

  @Override
  public void remove(Row row) {
    for (Coverage part : parts) {
      part.remove(row);
    }
  }

  @Override
  public void change(Row row, int column, int value) {
    int before = row.value(column);
    for (Coverage part : parts) {
      part.change(row, column, value);
      row.set(column, before);
    }
    row.set(column, value);
  }

  @Override
  public Tuple pick(SeededRandom random) {
    int left = random.nextInt(uncovered());
    int i = 0;
    while (left >= parts[i].uncovered()) {
      left -= parts[i++].uncovered();
    }
    return parts[i].pick(random);
  }

  @Override
  public void exclude(int[] columns, int[] values) {
    for (Coverage part : parts) {
      part.exclude(columns, values);
    }
  }

  @Override
  public int cost() {
    int sum = 0;
    for (Coverage part : parts) {
      sum += part.cost();
    }
    return sum;
  }

  @Override
  public int changeCost() {
    int sum = 0;
    for (Coverage part : parts) {
      sum += part.changeCost();
    }
    return sum;
  }
}
