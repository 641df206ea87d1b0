"""gearfilm for Spack, built from the checkout in which this file stands.

    spack repo add scripts/packaging/spack && spack install gearfilm
"""
import pathlib

from spack.package import *

try:  # Spack 1.0 and later
    from spack_repo.builtin.build_systems.cmake import CMakePackage
except ImportError:
    pass


class Gearfilm(CMakePackage):
    """Lubricant films and vibration of spur-gear pairs."""

    git = pathlib.Path(__file__).resolve().parents[5].as_uri()

    version("main", branch="main")

    depends_on("cxx", type="build")
    depends_on("c", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("pkgconfig", type="build")
    depends_on("mpi")
    depends_on("petsc@3.18: +mpi +double ~complex")
    depends_on("slepc@3.18:")
    depends_on("hdf5 +mpi")
    depends_on("fftw@3: precision=float,double")
    depends_on("yaml-cpp@0.7:")
    depends_on("nlohmann-json@3.10:")
    depends_on("eigen@3.4:")

    generator("ninja")

    def cmake_args(self):
        # Spack chooses the processor by its own flags.
        return [
            self.define("GEARFILM_NATIVE", False),
            self.define("GEARFILM_TESTS", False),
            self.define("HDF5_ROOT", self.spec["hdf5"].prefix),
        ]
