package org.sitaf.cli.campaign;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.campaign.Behaviour;
import org.sitaf.core.campaign.CampaignResult;
import org.sitaf.core.campaign.CampaignResult.Cell;
import org.sitaf.core.campaign.CampaignResult.Entry;
import org.sitaf.core.campaign.InjectedFault;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.description.fault.FaultKind;

/** Prints the result of a campaign: a table of devices and faults, and the failures. */
final class CampaignText {
  private static final String NONE = "-";

  private final WorldDescription world;
  private final CampaignResult result;
  private final PrintWriter out;

  CampaignText(WorldDescription world, CampaignResult result, PrintWriter out) {
    this.world = world;
    this.result = result;
    this.out = out;
  }

  void print() {
    Map<Cell, Entry> table = result.table();
    List<List<String>> rows = new ArrayList<>();
    List<String> head = new ArrayList<>(List.of("fault"));
    world.devices().forEach(d -> head.add(d.name()));
    rows.add(head);
    for (FaultKind kind : FaultKind.values()) {
      List<String> row = new ArrayList<>(List.of(kind.text()));
      for (Device device : world.devices()) {
        Entry entry = table.get(new Cell(device.name(), kind));
        row.add(entry == null ? NONE : entry.behaviour().text());
      }
      rows.add(row);
    }
    print(rows);
    out.println();
    out.println(
        result.entries().size()
            + " cases with faults: "
            + java.util.Arrays.stream(Behaviour.values())
                .map(
                    b ->
                        result.entries().stream().filter(e -> e.behaviour() == b).count()
                            + " "
                            + b.text())
                .collect(Collectors.joining(", ")));
    table.values().stream().filter(e -> e.behaviour().isFailure()).forEach(this::print);
    List<Entry> pairs = result.worsePairs();
    if (!pairs.isEmpty()) {
      out.println("pairs of faults of which none alone fails:");
      pairs.forEach(this::print);
    }
  }

  private void print(Entry entry) {
    out.println(
        "  case "
            + entry.campaignCase().no()
            + ", "
            + entry.campaignCase().faults().stream()
                .map(InjectedFault::text)
                .collect(Collectors.joining(" and "))
            + ": "
            + entry.behaviour().text()
            + ": "
            + Printable.line(entry.classified().reason()));
  }

  private void print(List<List<String>> rows) {
    int columns = rows.get(0).size();
    int[] widths = new int[columns];
    for (List<String> row : rows) {
      for (int i = 0; i < columns; i++) {
        widths[i] = Math.max(widths[i], row.get(i).length());
      }
    }
    for (List<String> row : rows) {
      StringBuilder line = new StringBuilder();
      for (int i = 0; i < columns; i++) {
        String padded = row.get(i) + " ".repeat(widths[i] - row.get(i).length());
        line.append(i == 0 ? "" : "  ").append(padded);
      }
      out.println(line.toString().stripTrailing());
    }
  }
}
