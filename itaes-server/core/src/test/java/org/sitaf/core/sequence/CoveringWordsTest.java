package org.sitaf.core.sequence;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.BitSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.sequence.array.TupleSpace;

@Tag("slow")
class CoveringWordsTest {
  private static List<int[]> words(int letters, int strength, int length, boolean repeat) {
    TupleSpace space = new TupleSpace(letters, strength);
    CoveringWords words = new CoveringWords(Machine.free(letters), space, length, repeat);
    return words.cover(words.allowed(), Effort.DEFAULT, 1, Progress.NONE);
  }

  /** The subsequences of all words, by enumeration of all choices of places. */
  private static Set<List<Integer>> subsequences(List<int[]> words, int strength) {
    Set<List<Integer>> found = new HashSet<>();
    for (int[] word : words) {
      for (long places = 0; places < 1L << word.length; places++) {
        if (Long.bitCount(places) == strength) {
          List<Integer> letters = new java.util.ArrayList<>();
          for (int p = 0; p < word.length; p++) {
            if ((places >> p & 1) == 1) {
              letters.add(word[p]);
            }
          }
          found.add(letters);
        }
      }
    }
    return found;
  }

  @ParameterizedTest
  @CsvSource({"5,3,7", "6,3,8", "8,3,9", "10,3,10", "6,4,27", "5,2,2", "4,1,1"})
  void distinctEventsNeedFewPermutations(int letters, int strength, int most) {
    List<int[]> words = words(letters, strength, letters, false);

    assertThat(words).hasSizeLessThanOrEqualTo(most);
    long tuples = 1;
    for (int i = 0; i < strength; i++) {
      tuples *= letters - i;
    }
    assertThat(subsequences(words, strength)).hasSize((int) tuples);
  }

  @ParameterizedTest
  @CsvSource({"4,2,4,5", "6,2,6,5", "8,2,8,4", "4,3,6,7", "8,3,8,16"})
  void stepsThatRepeatNeedFewWords(int letters, int strength, int length, int most) {
    needFewWords(letters, strength, length, most);
  }

  // './sitaf bench sequences' has these and many more.
  @ParameterizedTest
  @Tag("long")
  @CsvSource({"5,3,7,7", "5,3,9,4", "6,3,12,3", "3,4,8,8"})
  void stepsThatRepeatNeedFewWordsAlsoIfTheSearchIsLong(
      int letters, int strength, int length, int most) {
    needFewWords(letters, strength, length, most);
  }

  private static void needFewWords(int letters, int strength, int length, int most) {
    List<int[]> words = words(letters, strength, length, true);

    assertThat(words).hasSizeLessThanOrEqualTo(most);
    assertThat(words).allMatch(w -> w.length <= length);
    assertThat(subsequences(words, strength)).hasSize((int) Math.pow(letters, strength));
  }

  @org.junit.jupiter.api.Test
  void wordsOfFewerPlacesThanLettersHoldDistinctLetters() {
    List<int[]> words = words(6, 2, 4, false);

    assertThat(words).allMatch(w -> java.util.Arrays.stream(w).distinct().count() == w.length);
    assertThat(subsequences(words, 2)).hasSize(30);
  }

  @org.junit.jupiter.api.Test
  void aStepThatIsPossibleOnceIsNotRepeated() {
    // Step 0 leads from state 0 to state 1, where only step 1 is allowed.
    Machine machine = new Machine(2, new int[][][] {{{1}, {}}, {{}, {1}}});
    CoveringWords words = new CoveringWords(machine, new TupleSpace(2, 2), 3, true);

    BitSet allowed = words.allowed();

    assertThat(allowed.stream()).containsExactly(1, 3);
    assertThat(words.cover(allowed, Effort.DEFAULT, 1, Progress.NONE))
        .singleElement()
        .isEqualTo(new int[] {0, 1, 1});
  }

  @org.junit.jupiter.api.Test
  void everyWordContainsARequiredTuple() {
    // Steps 0 and 1 lead from one state to the other and back. The last step ends a word, as a
    // forbidden call does, and is possible in the second state; all required tuples end with it.
    int end = 10;
    int[][][] successors = new int[3][end + 1][];
    for (int step = 0; step <= end; step++) {
      successors[0][step] = step == 0 ? new int[] {1} : new int[] {0};
      successors[1][step] = step == 1 ? new int[] {0} : step == end ? new int[] {2} : new int[] {1};
      successors[2][step] = new int[0];
    }
    successors[0][1] = new int[0];
    successors[0][end] = new int[0];
    successors[1][0] = new int[0];
    TupleSpace space = new TupleSpace(end + 1, 3);
    CoveringWords words = new CoveringWords(new Machine(end + 1, successors), space, 5, true);
    BitSet required = words.allowed();
    for (int tuple = 0; tuple < space.size(); tuple++) {
      required.set(tuple, required.get(tuple) && space.letters(tuple)[2] == end);
    }

    for (long seed = 1; seed <= 6; seed++) {
      List<int[]> found = words.cover(required, Effort.FAST, seed, Progress.NONE);
      assertThat(found).as("seed " + seed).allMatch(word -> word[word.length - 1] == end);
    }
  }
}
