"""``macram predict``."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from macram.cli.examples import say_more
from macram.cli.pose_options import add_pose_options, pose_settings
from macram.cli.status import OK

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

DETAIL = (
    "Writes every picture with the object's box and axes, and poses.json (BOP names: cam_R_m2c row by row, "
    "cam_t_m2c in mm; null where nothing was found). The focal length comes from --focal, else from a "
    "scene_camera.json beside the picture's folder, else from the training if the picture has its size."
)
FARTHEST = 16.0
"""Largest factor between a picture's focal length and the training's; beyond it one of them is a mistake."""
EXAMPLES = """\
examples:
  macram predict photo.png -o build/poses --weights build/runs/quarter-wdr/model.safetensors --focal 620
  macram predict build/data/mini/testing/seq_*/000000/rgb/*.jpg -o build/poses --weights model.safetensors
  macram predict photo.png -o build/poses --weights quarter-float --looks 4 --edges 0.9928
"""


def add_predict(verb: Callable[[str, str, str, str], argparse.ArgumentParser]) -> None:
    """The grammar of ``macram predict``; ``verb`` makes a top-level verb."""
    sub = verb("predict", "predict_verb", "find the object's pose in pictures", DETAIL)
    say_more(sub, EXAMPLES)
    sub.add_argument("images", type=Path, nargs="+", metavar="IMAGE", help="PNG or JPEG")
    sub.add_argument("-o", "--out", type=Path, required=True, metavar="DIR", help="folder for the results")
    sub.add_argument(
        "--weights",
        required=True,
        metavar="MODEL",
        help="model.safetensors of a run, or a shipped name (macram weights list)",
    )
    sub.add_argument("--focal", type=float, help="focal length of the pictures in pixels")
    sub.add_argument("--integer", action="store_true", help="run the deployed integers (mode III, CPU)")
    sub.add_argument("--device", choices=("auto", "cpu", "cuda"), default="auto", help="default: auto")
    add_pose_options(sub)


def predict(arguments: argparse.Namespace) -> int:
    """Find poses and draw them."""
    # Late: the grammar above is loaded by every command, PyTorch is not.
    import numpy as np  # noqa: PLC0415
    from rich.console import Console  # noqa: PLC0415

    from macram.data.files import read_picture, write_json, write_picture  # noqa: PLC0415
    from macram.pose import draw_pose  # noqa: PLC0415
    from macram.train.distributed import join_processes  # noqa: PLC0415
    from macram.train.predict import Predictor  # noqa: PLC0415
    from macram.train.samples import box_of  # noqa: PLC0415
    from macram.weights import weights_file  # noqa: PLC0415

    names, settings = _names(arguments.images), pose_settings(arguments)
    device = join_processes("cpu" if arguments.integer else arguments.device).device
    predictor = Predictor.load(
        weights_file(arguments.weights), device, integer=arguments.integer, settings=settings
    )
    card = predictor.card
    # All pictures are read before the first result is written: a bad one leaves nothing behind.
    pictures = []
    for path in arguments.images:
        image = read_picture(path, colour=True, size=None)
        pictures.append((image, _camera(path, image, arguments.focal, card.focal, card.network.image_size)))
    arguments.out.mkdir(parents=True, exist_ok=True)
    table, console = {}, Console()
    corners = box_of(np.array(card.keypoints))
    for name, path, (image, camera), found in zip(
        names, arguments.images, pictures, predictor.detections(pictures), strict=True
    ):
        label = "no pose"
        if found is not None:
            image = draw_pose(image, found.pose, camera, corners, label=f"{found.score:.2f}")  # noqa: PLW2901
            x, y, z = found.pose.t.ravel()
            label = f"score {found.score:.2f}, at {x:.0f} {y:.0f} {z:.0f} mm, {found.inliers}/{found.pairs} inliers"
        write_picture(arguments.out / f"{name}.png", image)
        pose = None if found is None else found.to_dict()
        table[name] = {"image": str(path), "cam_K": camera.ravel().tolist(), "pose": pose}
        console.print(f"{path}: {label}", highlight=False, markup=False, soft_wrap=True)
    about = {"weights": arguments.weights, "target": card.target, "mode": card.mode, "bits": card.bits}
    about |= {"integer": arguments.integer, "solver": settings.words}
    write_json(arguments.out / "poses.json", {**about, "poses": table})
    return OK


def _names(images: list[Path]) -> list[str]:
    """A name per picture: its stem, numbered where stems meet."""
    stems = [path.stem for path in images]
    return [stem if stems.count(stem) == 1 else f"{n:04d}_{stem}" for n, stem in enumerate(stems)]


def _camera(
    path: Path, image: NDArray[np.uint8], focal: float | None, trained: float, size: int
) -> NDArray[np.float64]:
    """Intrinsics ``[3, 3]`` of a picture.

    Raises:
        ValueError: the focal length is unknown or not positive.
    """
    import numpy as np  # noqa: PLC0415

    from macram.data.swisscube import read_cameras  # noqa: PLC0415

    height, width = image.shape[:2]
    scene = path.resolve().parent.parent / "scene_camera.json"
    if focal is None and scene.is_file() and path.stem.isdecimal():
        cameras = read_cameras(scene)
        if int(path.stem) in cameras:
            return _within(path, cameras[int(path.stem)], trained)
    if focal is None:
        if (width, height) != (size, size):
            raise ValueError(
                f"{path}: {width}x{height} pixels, trained on {size}x{size}; give the focal length with --focal"
            )
        focal = trained
    if not 0 < focal < float("inf"):
        raise ValueError(f"--focal must be above 0, not {focal}")
    return _within(path, np.array([[focal, 0, width / 2], [0, focal, height / 2], [0, 0, 1]]), trained)


def _within(path: Path, camera: NDArray[np.float64], trained: float) -> NDArray[np.float64]:
    """``camera``, if bringing its picture to the focal length of the training is possible.

    Raises:
        ValueError: it would become so large or small that the focal length must be wrong.
    """
    if not 1 / FARTHEST <= trained / camera[0, 0] <= FARTHEST:
        raise ValueError(
            f"{path}: a focal length of {camera[0, 0]:g} pixels is too far from the training's {trained:g}; "
            "name the right one with --focal"
        )
    return camera
