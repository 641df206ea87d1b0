"""Command lines of the package: wrong words end it with one line and exit status 1."""
import argparse
import sys


class Parser(argparse.ArgumentParser):
    """A parser that says what is wrong in one line."""

    def error(self, message):
        sys.exit(f"gearfilm: {message}; '{self.prog} --help' lists what can be given")
