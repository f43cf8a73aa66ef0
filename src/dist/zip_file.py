"""A zip file whose bytes depend on its contents alone."""
import io
import zipfile

FIRST_DAY = (1980, 1, 1, 0, 0, 0)  # a zip file knows no earlier one


def zip_of(files):
    """The bytes of a zip file with {path: text or bytes}, sorted by path."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as archive:
        for path in sorted(files):
            entry = zipfile.ZipInfo(path, FIRST_DAY)
            entry.compress_type, entry.create_system, entry.external_attr = zipfile.ZIP_DEFLATED, 3, 0o100644 << 16
            archive.writestr(entry, files[path])
    return out.getvalue()
