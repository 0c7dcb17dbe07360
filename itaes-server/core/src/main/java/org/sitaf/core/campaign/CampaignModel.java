package org.sitaf.core.campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.description.fault.FaultName.Part;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;

/**
 * A model that is extended by faults. It expects no values, because expected values hold for
 * healthy devices; its conditions hold in every case.
 */
public final class CampaignModel {
  /** Longer than a case, because a value of a case is finite. */
  private static final double TO_THE_END_S = 1e6;

  private static final DataType NUMBER = new DataType.Scalar(ScalarType.DOUBLE);

  private final TestModel base;
  private final TestModel model;

  private CampaignModel(TestModel base, TestModel model) {
    this.base = base;
    this.model = model;
  }

  /** The model with the faults of some cases as inputs. */
  public static CampaignModel of(TestModel base, List<CampaignCase> cases) {
    Map<String, InputElement> inputs = new LinkedHashMap<>();
    base.inputs().forEach(i -> inputs.put(i.name(), i));
    for (CampaignCase campaignCase : cases) {
      for (InjectedFault fault : campaignCase.faults()) {
        for (Part part : List.of(Part.FAULT, Part.AT, Part.FOR)) {
          String name = fault.name().fault() + part.suffix();
          inputs.putIfAbsent(
              name,
              new InputElement(
                  name, InputKind.TDSD, "double", NUMBER, "", List.of(), List.of(), 0));
        }
      }
    }
    TestModel extended =
        base.withInputs(List.copyOf(inputs.values()))
            .withOutputs(base.outputs().stream().map(OutputElement::withoutExpected).toList())
            .withoutRelations();
    return new CampaignModel(base, extended);
  }

  /** The extended model. */
  public TestModel model() {
    return model;
  }

  /**
   * The values of a case.
   *
   * @param healthy the values of its case without faults, in the order of the base model
   */
  public List<Value> row(List<Value> healthy, CampaignCase campaignCase) {
    Map<String, Double> set = new LinkedHashMap<>();
    for (InjectedFault fault : campaignCase.faults()) {
      String name = fault.name().fault();
      set.put(name, fault.value());
      set.put(name + Part.AT.suffix(), fault.beginSeconds());
      set.put(name + Part.FOR.suffix(), fault.isTransient() ? fault.lengthSeconds() : TO_THE_END_S);
    }
    List<Value> row = new ArrayList<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      Double value = set.get(input.name());
      if (value != null) {
        row.add(
            input.value(
                value == Math.rint(value) && Math.abs(value) <= TO_THE_END_S
                    ? Long.toString(value.longValue())
                    : value.toString()));
      } else if (i < base.inputs().size()) {
        row.add(healthy.get(i));
      } else {
        row.add(input.value(neutral(input.name())));
      }
    }
    return row;
  }

  private static String neutral(String input) {
    FaultName name = FaultName.parse(input);
    return name.part() == Part.FOR
        ? Long.toString((long) TO_THE_END_S)
        : name.part() == Part.FAULT ? Double.toString(name.kind().neutral()) : "0";
  }
}
