"""The clock of a node follows the simulation; this class is here for nodes that ask for it."""

USE_SIM_TIME_NAME = "use_sim_time"
CLOCK_TOPIC = "/clock"
