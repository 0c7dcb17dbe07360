package org.sitaf.core.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.core.compare.Confirmation.Decision;

class ConfirmationTest {
  private static Difference difference(int no, DifferenceClass kind, String output) {
    return new Difference("M", no, true, kind, output, Map.of(), "1", "2", null, "", 1);
  }

  private static final Difference VALUE = difference(1, DifferenceClass.VALUE, "return");
  private static final Difference OTHER = difference(2, DifferenceClass.VALUE, "return");

  @Test
  void runsThatAgreeConfirm() {
    Confirmation confirmation = new Confirmation(List.of(VALUE, OTHER));
    confirmation.add(List.of(), List.of());
    assertThat(confirmation.all(Decision.CONFIRMED)).containsExactly(VALUE, OTHER);
    assertThat(confirmation.isOpen()).isTrue();
  }

  @Test
  void runsOfOneVersionThatDisagreeMakeTheirCaseUnstable() {
    Confirmation confirmation = new Confirmation(List.of(VALUE, OTHER));
    confirmation.add(List.of(VALUE), List.of(VALUE));
    assertThat(confirmation.all(Decision.UNSTABLE)).containsExactly(VALUE);
    assertThat(confirmation.all(Decision.CONFIRMED)).containsExactly(OTHER);
    confirmation.add(List.of(OTHER), List.of(OTHER));
    assertThat(confirmation.isOpen()).isFalse();
  }

  @Test
  void runsThatDisagreeWithTheFirstOneOnlyMayDependOnOtherCases() {
    Confirmation confirmation = new Confirmation(List.of(VALUE));
    confirmation.add(List.of(VALUE), List.of());
    assertThat(confirmation.of(VALUE)).isEqualTo(Decision.DEPENDS_ON_OTHER_CASES);
  }

  @Test
  void aDisagreementDoubtsWhatItConcerns() {
    Difference error = difference(1, DifferenceClass.ERROR, "");
    Difference motion = difference(1, DifferenceClass.TRAJECTORY, "robot_x");
    assertThat(error.castsDoubtOn(VALUE)).isTrue();
    assertThat(VALUE.castsDoubtOn(error)).isFalse();
    assertThat(VALUE.castsDoubtOn(OTHER)).isFalse();
    assertThat(difference(1, DifferenceClass.VALUE, "reached").castsDoubtOn(VALUE)).isFalse();
    assertThat(difference(1, DifferenceClass.TRAJECTORY, "robot_y").castsDoubtOn(motion)).isTrue();
    assertThat(VALUE.castsDoubtOn(difference(1, DifferenceClass.VERDICT, ""))).isTrue();
  }
}
