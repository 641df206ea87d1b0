"""What saved figures of Matplotlib show: no axes may be empty, or show what is not finite alone."""
import numpy
from matplotlib import collections, figure


def shown(artist):
    """The data of an artist: an array, empty where it shows nothing."""
    if isinstance(artist, collections.PathCollection):
        data = artist.get_offsets()
    elif isinstance(artist, collections.QuadMesh) or hasattr(artist, "get_extent") and hasattr(artist, "get_array"):
        data = artist.get_array()
    elif isinstance(artist, collections.Collection):
        data = numpy.concatenate([path.vertices for path in artist.get_paths()] or [numpy.empty((0, 2))])
    elif hasattr(artist, "get_xydata"):
        data = artist.get_xydata()
    else:  # a patch
        data = artist.get_patch_transform().transform(artist.get_path().vertices)
    return numpy.ma.filled(numpy.ma.asarray(data, dtype=float), numpy.nan)


def require_drawn(drawing):
    """Raises AssertionError for a figure without axes, or one of whose axes shows nothing finite."""
    assert drawing.axes, "a figure has no axes"
    for axes in drawing.axes:
        if not axes.get_visible() or not axes.axison and not axes.has_data():
            continue
        artists = [*axes.lines, *axes.collections, *axes.images, *axes.patches]
        # A row of finite numbers is a point, or a line of a map.
        finite = [numpy.isfinite(shown(artist)).any() if numpy.ndim(shown(artist)) < 2 else
                  numpy.isfinite(shown(artist)).all(axis=-1).any() for artist in artists]
        assert any(finite), f"an axes titled '{axes.get_title()}' of {len(artists)} artists shows no finite value"


def check_saved_figures():
    """From here on every figure that this process saves is looked at."""
    save = figure.Figure.savefig

    def checked(self, *arguments, **options):
        require_drawn(self)
        return save(self, *arguments, **options)

    figure.Figure.savefig = checked
