"""Animation of a mesh cycle: film and pressure of the contacts in mesh, the force and the motion beside them.

Of `gearfilm periodic`, or of `transient` with -output_snapshot_interval: one contact is followed from its first to its
last snapshot.
"""
import pathlib

from ..folder import RunFolder
from .cycle import write_cycle


def command(parser, words):
    """Writes FOLDER/cycle.gif, or as the words say."""
    parser.add_argument("folder", type=pathlib.Path, help="folder with results.h5 of gearfilm periodic or transient")
    parser.add_argument("--name", default="cycle", help="file name of the animation, without ending (%(default)s)")
    parser.add_argument("--contact", type=int, help="its number; that with most snapshots by default")
    parser.add_argument("--format", choices=("gif", "mp4"), default="gif", help="(%(default)s); mp4 needs ffmpeg")
    arguments = parser.parse_args(words)
    path = arguments.folder / f"{arguments.name}.{arguments.format}"
    write_cycle(RunFolder(arguments.folder), path, arguments.contact)
    print(f"animation: {path}")
