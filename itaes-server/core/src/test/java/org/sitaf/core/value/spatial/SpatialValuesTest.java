package org.sitaf.core.value.spatial;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sitaf.core.combine.SeededRandom;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.RotationForm;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;

class SpatialValuesTest {
  private static final DataType NUMBER = new DataType.Scalar(ScalarType.DOUBLE);

  private static DataType struct(String... names) {
    return new DataType.Struct(
        "S", List.of(names).stream().map(n -> new DataType.Member(n, NUMBER)).toList());
  }

  private static List<String> rotations(RotationForm form, DataType type, int count) {
    return SpatialValues.rotations(
            new TestSpec.Rotations(form, count), type, new SeededRandom(1)::nextDouble)
        .stream()
        .map(Value::literal)
        .toList();
  }

  @Test
  void aRotationIsWrittenInTheOrderOfTheMembers() {
    assertThat(rotations(null, struct("w", "x", "y", "z"), 5))
        .containsExactly(
            "{w: 1.0, x: 0.0, y: 0.0, z: 0.0}",
            "{w: 0.0, x: 1.0, y: 0.0, z: 0.0}",
            "{w: 0.0, x: 0.0, y: 1.0, z: 0.0}",
            "{w: 0.0, x: 0.0, y: 0.0, z: 1.0}",
            "{w: 0.7071067811865476, x: 0.7071067811865476, y: 0.0, z: 0.0}");
    assertThat(rotations(null, struct("roll", "pitch", "yaw"), 3).get(1))
        .isEqualTo("{roll: 3.141592653589793, pitch: 0.0, yaw: 0.0}");
  }

  @Test
  void cellsOfASequenceHaveTheOrderOfTheForm() {
    DataType sequence = TypeGrammar.parse("sequence<double>").type();
    assertThat(rotations(RotationForm.QUATERNION_XYZW, sequence, 1))
        .containsExactly("[0.0, 0.0, 0.0, 1.0]");
    assertThat(rotations(RotationForm.QUATERNION_WXYZ, sequence, 1))
        .containsExactly("[1.0, 0.0, 0.0, 0.0]");
    assertThat(rotations(RotationForm.MATRIX, sequence, 2).get(1))
        .isEqualTo("[1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0]");
    assertThat(rotations(RotationForm.MATRIX, TypeGrammar.parse("double[3][3]").type(), 2).get(1))
        .isEqualTo("[[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]]");
  }

  @Test
  void theFirstRotationsAreThoseOfTheCube() {
    List<String> all =
        rotations(RotationForm.MATRIX, TypeGrammar.parse("sequence<double>").type(), 24);
    assertThat(all).doesNotHaveDuplicates().hasSize(24);
    assertThat(all).allMatch(m -> m.matches("\\[(-?[01]\\.0(, )?){9}]"));
  }

  @ParameterizedTest
  @EnumSource(RotationForm.class)
  void everyFormDescribesTheSameRotations(RotationForm form) {
    DataType type = TypeGrammar.parse("sequence<double>").type();
    SpatialType written = SpatialType.rotation(type, form);
    List<String> literals = rotations(form, type, 24);
    List<String> quaternions = rotations(RotationForm.QUATERNION_XYZW, type, 24);
    for (int i = 0; i < literals.size(); i++) {
      // A turn by half a turn about z and back is no turn; it passes through the other form.
      String turned = written.turned(written.turned(literals.get(i), 0.5), -0.5);
      List<?> one = (List<?>) Variables.plain(turned, type);
      List<?> other = (List<?>) Variables.plain(literals.get(i), type);
      if (form != RotationForm.RPY) {
        for (int c = 0; c < one.size(); c++) {
          double product = form == RotationForm.MATRIX ? 1 : sign(one, other);
          assertThat((Double) one.get(c) * product)
              .as(quaternions.get(i))
              .isCloseTo((Double) other.get(c), within(1e-12));
        }
      }
    }
  }

  private static double sign(List<?> one, List<?> other) {
    double product = 0;
    for (int c = 0; c < one.size(); c++) {
      product += (Double) one.get(c) * (Double) other.get(c);
    }
    return Math.signum(product);
  }

  @Test
  void quaternionsHaveLengthOneAndAPositiveFirstNumber() {
    DataType type = struct("x", "y", "z", "w");
    List<String> all = rotations(null, type, 200);
    assertThat(all).hasSize(200).doesNotHaveDuplicates();
    for (String literal : all) {
      Map<?, ?> q = (Map<?, ?>) Variables.plain(literal, type);
      double sum = 0;
      double first = 0;
      for (String name : List.of("w", "x", "y", "z")) {
        double number = (Double) q.get(name);
        sum += number * number;
        first = first == 0 ? number : first;
      }
      assertThat(sum).isCloseTo(1, within(1e-12));
      assertThat(first).isPositive();
    }
  }

  @Test
  void directionsHaveTheLength() {
    DataType type = struct("x", "y", "z");
    List<Value> all =
        SpatialValues.directions(
            new TestSpec.Directions(40, 2), type, new SeededRandom(1)::nextDouble);
    assertThat(all).hasSize(40);
    assertThat(all.get(1).literal()).isEqualTo("{x: -2.0, y: 0.0, z: 0.0}");
    for (Value value : all) {
      Map<?, ?> v = (Map<?, ?>) Variables.plain(value.literal(), type);
      double sum = v.values().stream().mapToDouble(n -> (Double) n * (Double) n).sum();
      assertThat(sum).isCloseTo(4, within(1e-12));
    }
  }

  @Test
  void aHalfTurnGivesExactlyTheOppositeDirection() {
    SpatialType type = SpatialType.direction(struct("x", "y", "z"));
    assertThat(type.turned("{x: -0.6, y: 0.8, z: 0.0}", Math.PI))
        .isEqualTo("{x: 0.6, y: -0.8, z: 0.0}");
    assertThat(type.turned("{x: 0.0, y: 0.0, z: 1.0}", -Math.PI))
        .isEqualTo("{x: 0.0, y: 0.0, z: -1.0}");
    assertThat(type.turned("{x: 0.0, y: 0.0, z: -1.0}", Math.PI / 2))
        .isEqualTo("{x: 0.0, y: 1.0, z: 0.0}");
    assertThat(type.turned("{x: 1.0, y: 0.0, z: 0.0}", 1e-17))
        .isEqualTo("{x: 1.0, y: 1.0E-17, z: 0.0}");
  }

  @Test
  void aPoseHasAPositionAndAnOrientation() {
    DataType type =
        new DataType.Struct(
            "Pose",
            List.of(
                new DataType.Member("position", struct("x", "y", "z")),
                new DataType.Member("orientation", struct("x", "y", "z", "w"))));
    TestSpec.Poses spec = new TestSpec.Poses(null, 12, 0, 2);
    assertThat(SpatialValues.poses(spec, type, new SeededRandom(1)::nextDouble).get(8).literal())
        .startsWith("{position: {x: 1.0, y: 1.0, z: 1.0}, orientation: {x: 0.0, y: 0.0,");
    assertThat(
            SpatialValues.poses(
                    spec, TypeGrammar.parse("double[7]").type(), new SeededRandom(1)::nextDouble)
                .get(0)
                .literal())
        .isEqualTo("[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]");
  }

  @Test
  void aTypeThatCannotHoldTheValuesIsRefused() {
    assertThatThrownBy(() -> rotations(RotationForm.QUATERNION_XYZW, struct("a", "b"), 1))
        .hasMessageContaining("needs the members x, y, z, w, but it has a, b");
    assertThatThrownBy(() -> rotations(null, TypeGrammar.parse("double[3]").type(), 1))
        .hasMessageContaining("cannot hold 4 cells");
  }
}
