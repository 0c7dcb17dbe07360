package org.sitaf.core.campaign;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sitaf.core.campaign.Classification.Classified;
import org.sitaf.core.description.fault.FaultKind;

/** What the component did in the cases of a campaign. */
public final class CampaignResult {
  private final List<Entry> entries;

  /**
   * A result.
   *
   * @param entries the executed cases in their order
   */
  public CampaignResult(List<Entry> entries) {
    this.entries = List.copyOf(entries);
  }

  /** One executed case. */
  public record Entry(CampaignCase campaignCase, Classified classified) {
    /** What the component did. */
    public Behaviour behaviour() {
      return classified.behaviour();
    }

    boolean isSingle() {
      return campaignCase.faults().size() == 1;
    }
  }

  /** A device with a fault, which is a cell of the table. */
  public record Cell(String device, FaultKind fault) {
    static Cell of(InjectedFault fault) {
      return new Cell(fault.name().device(), fault.name().kind());
    }
  }

  /** All cases. */
  public List<Entry> entries() {
    return entries;
  }

  /** The worst behaviour of each fault alone, by device and fault. */
  public Map<Cell, Entry> table() {
    Map<Cell, Entry> table = new LinkedHashMap<>();
    for (Entry entry : entries) {
      if (entry.isSingle()) {
        table.merge(
            Cell.of(entry.campaignCase().faults().get(0)),
            entry,
            (a, b) -> b.behaviour().compareTo(a.behaviour()) > 0 ? b : a);
      }
    }
    return table;
  }

  /** Pairs that fail although each of their faults alone does not. */
  public List<Entry> worsePairs() {
    Map<Cell, Entry> table = table();
    List<Entry> worse = new ArrayList<>();
    for (Entry entry : entries) {
      if (!entry.isSingle()
          && entry.behaviour().isFailure()
          && entry.campaignCase().faults().stream()
              .map(fault -> Optional.ofNullable(table.get(Cell.of(fault))))
              .noneMatch(single -> single.isPresent() && single.get().behaviour().isFailure())) {
        worse.add(entry);
      }
    }
    return worse;
  }

  /** Whether the component fails in a case. */
  public boolean hasFailures() {
    return entries.stream().anyMatch(e -> e.behaviour().isFailure());
  }
}
