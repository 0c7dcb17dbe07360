package org.sitaf.cli.campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.core.campaign.CampaignResult;
import org.sitaf.core.campaign.CampaignResult.Entry;
import org.sitaf.core.campaign.InjectedFault;
import org.sitaf.core.description.fault.FaultName.Part;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import tools.jackson.databind.json.JsonMapper;

/** Writes the result of a campaign as JSON. */
final class CampaignJson {
  private CampaignJson() {}

  static String write(TestModel model, CampaignResult result, List<List<Value>> bases) {
    Map<String, Object> root = new LinkedHashMap<>();
    root.put("model", model.name());
    root.put("cases", result.entries().size());
    List<Object> table = new ArrayList<>();
    result
        .table()
        .forEach(
            (cell, entry) -> {
              Map<String, Object> row = new LinkedHashMap<>();
              row.put("device", cell.device());
              row.put("fault", cell.fault().text());
              row.put("behaviour", entry.behaviour().text());
              row.put("case", entry.campaignCase().no());
              table.add(row);
            });
    root.put("table", table);
    List<Object> cases = new ArrayList<>();
    for (Entry entry : result.entries()) {
      Map<String, Object> row = new LinkedHashMap<>();
      row.put("no", entry.campaignCase().no());
      Map<String, Object> inputs = new LinkedHashMap<>();
      List<Value> base = bases.get(entry.campaignCase().base());
      for (int i = 0; i < model.inputs().size(); i++) {
        inputs.put(model.inputs().get(i).name(), base.get(i).literal());
      }
      for (InjectedFault fault : entry.campaignCase().faults()) {
        inputs.put(fault.name().text(), fault.value());
        inputs.put(fault.name().text() + Part.AT.suffix(), fault.beginSeconds());
        if (fault.isTransient()) {
          inputs.put(fault.name().text() + Part.FOR.suffix(), fault.lengthSeconds());
        }
      }
      row.put("inputs", inputs);
      row.put("behaviour", entry.behaviour().text());
      row.put("message", entry.classified().reason());
      cases.add(row);
    }
    root.put("results", cases);
    root.put("worse_pairs", result.worsePairs().stream().map(e -> e.campaignCase().no()).toList());
    return new JsonMapper().writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
  }
}
