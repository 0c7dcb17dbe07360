package org.sitaf.runtime;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.function.IntSupplier;
import org.junit.jupiter.api.Test;

class ComponentUnderTestTest {
  private final IntSupplier stub = () -> 42;

  /** Has several constructors. */
  public static class Choosy {
    final Object given;

    public Choosy() {
      given = "nothing";
    }

    public Choosy(IntSupplier supplier) {
      given = supplier;
    }

    public Choosy(IntSupplier supplier, Thread unavailable) {
      given = unavailable;
    }
  }

  /** Has a constructor whose parameter no test provides. */
  public static class Demanding {
    public Demanding(Hardware hardware, Thread thread) {}
  }

  /** Throws in its constructor. */
  public static class Failing {
    public Failing() {
      throw new IllegalStateException("no calibration");
    }
  }

  /** Has setters. */
  public static class Settable {
    int size;
    double gain;
    boolean on;
    String label = "";

    public void setSize(int newSize) {
      size = newSize;
    }

    public void setGain(double newGain) {
      gain = newGain;
    }

    public void setOn(boolean newOn) {
      on = newOn;
    }

    public void setLabel(String newLabel) {
      label = newLabel;
    }

    public void setBroken(int value) {
      throw new IllegalArgumentException("broken " + value);
    }
  }

  /** Has a general setter. */
  public static class General extends Settable {
    String last = "";

    public void setProperty(String name, String value) {
      last = name + "=" + value;
    }
  }

  @Test
  void usesTheConstructorWithTheMostAvailableParameters() throws Exception {
    assertThat(ComponentUnderTest.create(Choosy.class, stub).given).isSameAs(stub);
    assertThat(ComponentUnderTest.create(Choosy.class).given).isEqualTo("nothing");
  }

  @Test
  void reportsAConstructorWhoseParametersAreNotAvailable() {
    assertThatThrownBy(() -> ComponentUnderTest.create(Demanding.class, stub))
        .isInstanceOf(CannotRunException.class)
        .hasMessageContaining("ComponentUnderTestTest$Demanding has no public constructor")
        .hasMessageContaining("any of: java.util.function.IntSupplier")
        .hasMessageContaining("(org.sitaf.runtime.Hardware, java.lang.Thread)");
    assertThatThrownBy(() -> ComponentUnderTest.create(Runnable.class))
        .isInstanceOf(CannotRunException.class)
        .hasMessageContaining("is abstract");
  }

  @Test
  void rethrowsExceptionsOfConstructorsAndSetters() {
    assertThatThrownBy(() -> ComponentUnderTest.create(Failing.class))
        .isInstanceOf(IllegalStateException.class)
        .hasMessage("no calibration");
    assertThatThrownBy(() -> ComponentUnderTest.setProperty(new Settable(), "Broken", "3"))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessage("broken 3");
  }

  @Test
  void convertsPropertiesToTheTypeOfTheSetter() throws Exception {
    Settable component = new Settable();
    ComponentUnderTest.setProperty(component, "Size", "7");
    ComponentUnderTest.setProperty(component, "gain", "0.5");
    ComponentUnderTest.setProperty(component, "on", "true");
    ComponentUnderTest.setProperty(component, "label", " x ");
    assertThat(component.size).isEqualTo(7);
    assertThat(component.gain).isEqualTo(0.5);
    assertThat(component.on).isTrue();
    assertThat(component.label).isEqualTo(" x ");
  }

  @Test
  void prefersTheGeneralSetter() throws Exception {
    General component = new General();
    ComponentUnderTest.setProperty(component, "Size", "7");
    assertThat(component.last).isEqualTo("Size=7");
    assertThat(component.size).isZero();
  }

  @Test
  void reportsAPropertyThatCannotBeSet() {
    assertThatThrownBy(() -> ComponentUnderTest.setProperty(new Settable(), "Colour", "red"))
        .isInstanceOf(CannotRunException.class)
        .hasMessageContaining("has neither setProperty(String, String) nor setColour(...)");
    assertThatThrownBy(() -> ComponentUnderTest.setProperty(new Settable(), "Size", "seven"))
        .isInstanceOf(CannotRunException.class)
        .hasMessageContaining("setSize takes int, which cannot be made of 'seven'");
  }
}
