from setuptools import setup

setup(
    name="wall_stop",
    version="1.0.0",
    packages=["wall_stop"],
    data_files=[("share/ament_index/resource_index/packages", ["resource/wall_stop"]), ("share/wall_stop", ["package.xml"])],
    entry_points={"console_scripts": ["wall_stop = wall_stop.follower:main"]},
)
