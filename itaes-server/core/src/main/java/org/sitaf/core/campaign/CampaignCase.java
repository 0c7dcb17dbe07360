package org.sitaf.core.campaign;

import java.util.List;

/**
 * One case of a campaign.
 *
 * @param no from 1
 * @param base index of the case without faults whose inputs it has
 * @param faults one or two
 */
public record CampaignCase(int no, int base, List<InjectedFault> faults) {
  public CampaignCase {
    faults = List.copyOf(faults);
    if (faults.isEmpty()) {
      throw new IllegalArgumentException("a case of a campaign has a fault");
    }
  }
}
