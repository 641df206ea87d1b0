"""What saved figures of Matplotlib show: no axes may be empty, or show what is not finite alone."""
import numpy
from matplotlib import figure


def shown(artist):
    """The data of an artist: an array, empty where it shows nothing."""
    for values in ("get_xydata", "get_array", "get_offsets", "get_xy"):
        if hasattr(artist, values):
            data = getattr(artist, values)()
            if data is not None and numpy.size(data):
                return numpy.ma.filled(numpy.ma.asarray(data, dtype=float), numpy.nan)
    if hasattr(artist, "get_paths"):
        return numpy.concatenate([path.vertices for path in artist.get_paths()] or [numpy.empty((0, 2))])
    return numpy.empty(0)


def require_drawn(drawing):
    """Raises AssertionError for a figure without axes, or one of whose axes shows nothing finite."""
    assert drawing.axes, "a figure has no axes"
    for axes in drawing.axes:
        if not axes.get_visible() or not axes.axison and not axes.has_data():
            continue
        artists = [*axes.lines, *axes.collections, *axes.images, *axes.patches, *axes.texts]
        finite = [numpy.isfinite(shown(artist)).any() for artist in [*axes.lines, *axes.collections, *axes.images, *axes.patches]]
        assert any(finite), f"an axes titled '{axes.get_title()}' of {len(artists)} artists shows no finite value"


def check_saved_figures():
    """From here on every figure that this process saves is looked at."""
    save = figure.Figure.savefig

    def checked(self, *arguments, **options):
        require_drawn(self)
        return save(self, *arguments, **options)

    figure.Figure.savefig = checked
