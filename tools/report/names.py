"""Names of kernels, layouts and machines as people read them, their order and their colours."""
import re

KERNELS = {
    "dp_from_df": "dP from dF",
    "force_chain_fused": "positions to forces, fused",
    "force_chain_fused_fixed_order": "positions to forces, fused, in a fixed order",
    "force_chain_fused_gathered": "positions to forces, fused but for the gather",
    "force_chain_separate": "positions to forces, five kernels",
    "matrix_free_fused": "matrix-free product, fused",
    "matrix_free_separate": "matrix-free product, two kernels",
    "newton_update_fused": "Newton update, fused",
    "newton_update_separate": "Newton update, five kernels",
    "svd": "SVD",
    "svd_3_sweeps": "SVD, 3 sweeps",
    "svd_5_sweeps": "SVD, 5 sweeps",
    "svd_quaternions": "SVD, quaternions",
    "svd_without_u": "SVD without U",
    "svd_without_v": "SVD without V",
    "tet_stiffness": "tetrahedron stiffness",
}
LAYOUTS = {
    "aos": "AoS",
    "aos_scalar": "AoS, object by object",
    "aos_padded": "padded AoS",
    "aos_three_arrays": "AoS, three arrays",
    "soa": "SoA",
    "record": "whole element records",
    "scattered": "scattered objects",
    "symmetric_fast": "symmetric half, fast",
    "symmetric_deterministic": "symmetric half, deterministic",
    "cusparse_bsr_columns": "cuSPARSE BSR, blocks by columns",
    "cusparse_bsr_rows": "cuSPARSE BSR, blocks by rows",
    "cusolver": "cuSOLVER",
    "eigen": "Eigen",
    "copy": "copy",
}
ORDER = [
    "record",
    "aos",
    "aos_scalar",
    "aos_padded",
    "aos_three_arrays",
    "soa",
    "aosoa",
    "symmetric_fast",
    "symmetric_deterministic",
]
LIBRARIES = {"eigen", "cusolver", "cusparse_bsr_columns", "cusparse_bsr_rows"}  # not ours

# Okabe and Ito's palette, which colour-blind readers can tell apart.
_ORANGE, _SKY, _GREEN, _BLUE, _VERMILION, _PURPLE = "#e69f00", "#56b4e9", "#009e73", "#0072b2", "#d55e00", "#cc79a7"
ACCENT, SERIES = _BLUE, [_BLUE, _ORANGE, _GREEN, _PURPLE, _VERMILION, _SKY]
_COLOURS = {
    "aos": _VERMILION,
    "aos_scalar": _ORANGE,
    "aos_padded": _ORANGE,
    "soa": _SKY,
    "aosoa": _BLUE,
    "record": _PURPLE,
    "symmetric_fast": _GREEN,
    "symmetric_deterministic": _GREEN,
}


def kernel(name):
    return KERNELS.get(name, name.replace("_", " "))


def layout(name):
    """`aosoa32` -> AoSoA-32; `aos_to_soa` -> AoS → SoA; what is not known stays, without underscores."""
    if "_to_" in name:
        return " → ".join(layout(side) for side in name.split("_to_", 1))
    tiles = re.fullmatch(r"aosoa(\d+)(.*)", name)
    if tiles:
        return f"AoSoA-{tiles[1]}" + tiles[2].replace("_", " ")
    return LAYOUTS.get(name, name.replace("_", " "))


def _family(name):
    return "aosoa" if name.startswith("aosoa") else name


def layout_order(name):
    """Sort key: ours in a fixed order, then what is not known, then other people's libraries."""
    family = _family(name)
    return (
        name in LIBRARIES,
        ORDER.index(family) if family in ORDER else len(ORDER),
        [int(part) if part.isdigit() else part for part in re.split(r"(\d+)", name)],
    )


def layout_colour(name):
    return _COLOURS.get(_family(name), "#8c8c8c")


def slug(text):
    """A file name or id: letters, digits and hyphens."""
    return re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-")


# ---- Numbers ---------------------------------------------------------------------------------------------------------
def significant(value, digits=3):
    """3 digits, without an exponent between 1e-3 and 1e6: 0.0368, 1.65, 12.2, 4,180."""
    if value == 0:
        return "0"
    if not 1e-3 <= abs(value) < 1e6:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}e{int(exponent)}"
    decimals = max(0, digits - len(str(int(abs(value)))) if abs(value) >= 1 else digits - 1 + _leading_zeros(value))
    return f"{value:,.{decimals}f}"


def _leading_zeros(value):
    zeros, value = 0, abs(value)
    while value < 1:
        zeros, value = zeros + 1, value * 10
    return zeros


def times(value):
    """A factor with two decimals, fewer where it is large: 1.65×, 13.0×, 4,650×."""
    return f"{value:,.{2 if value < 10 else 1 if value < 100 else 0}f}×"
