from setuptools import setup

setup(
    name="heater",
    version="1.0.0",
    packages=["heater"],
    data_files=[("share/ament_index/resource_index/packages", ["resource/heater"]), ("share/heater", ["package.xml"])],
    entry_points={"console_scripts": ["heater = heater.heater:main"]},
)
