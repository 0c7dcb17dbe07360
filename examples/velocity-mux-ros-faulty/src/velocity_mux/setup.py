from setuptools import setup

setup(
    name="velocity_mux",
    version="1.0.0",
    packages=["velocity_mux"],
    data_files=[("share/ament_index/resource_index/packages", ["resource/velocity_mux"]), ("share/velocity_mux", ["package.xml"])],
    entry_points={"console_scripts": ["velocity_mux = velocity_mux.mux:main"]},
)
