"""Sessions: isolated simulations that live until their lease expires."""
