"""The scene as Mitsuba gets it, and, where Mitsuba is installed, what Mitsuba makes of it."""

from __future__ import annotations

import argparse
import shutil
import sys

import cv2
import numpy as np
import pytest

from macram.cli.data_grammar import add_data
from macram.cli.data_verb import data
from macram.data.geometry import project
from macram.data.produce import produce
from macram.data.render.cubesat import DIAMETER_MM, cubesat
from macram.data.render.earth import Earth
from macram.data.render.mitsuba_scene import scene_of, silhouette_of
from macram.data.render.plan import EARTH_KM, View, plan_sequence
from macram.data.spec import RenderSpec

VIEW = View(96, 64, 110.0)
SPEC = RenderSpec((96, 64), 110.0, (1.6, 2.4), (2, 0, 0), 2, seed=3)


def run(*words):
    top = argparse.ArgumentParser()
    verbs = top.add_subparsers(dest="verb")
    add_data(lambda name, module, summary, detail: verbs.add_parser(name, help=summary, description=detail))
    return data(top.parse_args(["data", *map(str, words)]))


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    root = tmp_path_factory.mktemp("compared") / "set"
    assert list(produce(root, SPEC))[-1] == 4
    return root


@pytest.fixture(scope="module")
def scene():
    plan = plan_sequence((5, 0, 0), 3, VIEW, (1.6 * DIAMETER_MM, 2.4 * DIAMETER_MM), 108.8)
    return plan, Earth(plan), scene_of(plan, Earth(plan), 2, VIEW, 16)


def rectangles(scene):
    return [part for part in scene.values() if isinstance(part, dict) and part["type"] == "rectangle"]


def test_rectangles_lie_where_our_camera_sees_the_patches(scene):
    plan, _, parts = scene
    square = np.array([[-1, -1, 0, 1], [1, -1, 0, 1], [1, 1, 0, 1], [-1, 1, 0, 1.0]])
    found = np.stack([(square @ part["to_world"].T)[:, :3] for part in rectangles(parts)])
    camera = VIEW.matrix, np.eye(3), np.zeros((3, 1))
    wanted = project(
        VIEW.matrix, plan.rotations[2], plan.translations[2][:, None], cubesat().corners.reshape(-1, 3)
    )
    assert np.allclose(project(*camera, found.reshape(-1, 3)), wanted, atol=1e-6)
    for part in rectangles(parts):
        assert np.linalg.det(part["to_world"][:3, :3]) > 0  # normals outwards
        assert part["bsdf"]["id"] in {p.get("id") for p in parts.values() if isinstance(p, dict)}


def test_the_sensor_is_our_camera(scene):
    sensor = scene[2]["sensor"]
    film = sensor["film"]
    assert (film["width"], film["height"]) == (96, 64)
    assert np.isclose(48 / np.tan(np.radians(sensor["fov"] / 2)), VIEW.focal)
    # x to the right and y down in our frame are minus x and minus y in Mitsuba's.
    assert np.array_equal(sensor["to_world"] @ [-1, -1, 1, 1], [1, 1, 1, 1])


def test_the_sun_and_the_ground_are_the_plans(scene):
    plan, earth, parts = scene
    assert np.allclose(parts["sun"]["direction"], -(plan.cameras[2] @ plan.sun))
    assert parts["sun"]["irradiance"]["value"] == 1
    globe = parts["earth"]["to_world"]
    radius = np.linalg.norm(globe[:3, 0])
    height = np.linalg.norm(globe[:3, 3]) - radius
    assert np.isclose(height / radius, plan.altitude / EARTH_KM)
    assert np.allclose(globe[:3, 2] / radius, plan.cameras[2][:, 2])  # its pole points to our zenith
    albedo = parts["earth"]["bsdf"]["reflectance"]["bitmap"]
    # Below the camera: the ground itself where the sky is clear, brighter where a cloud is.
    row, column = np.rint(plan.drift[2][::-1] * earth.scale + len(earth.ground) / 2 - 0.5).astype(int)
    below = albedo[0].mean(axis=0)
    if earth.sky[row, column, 0] < -0.3:
        assert np.allclose(below, earth.ground[row, column, :3], atol=0.08)
    else:
        assert (below >= earth.ground[row, column, :3] - 0.08).all()


def test_textures_are_reflectances_and_no_array_is_left_unnamed(scene):
    found = []

    def walk(part, name):
        if isinstance(part, dict):
            for key, value in part.items():
                walk(value, key)
        elif isinstance(part, np.ndarray):
            assert name in ("bitmap", "to_world")
            if name == "bitmap":
                found.append(part)

    walk(scene[2], "")
    # Three textures for each of 14 materials, tilts of the one that is wrinkled, the ground.
    assert len(found) == 3 * 14 + 1 + 1
    for texels in found:
        assert texels.dtype == np.float32
        assert 0 <= texels.min() <= texels.max() <= 1


def test_the_silhouette_scene_is_the_target_alone(scene):
    alone = silhouette_of(scene[2])
    assert set(scene[2]) - set(alone) == {"sun", "earth"}
    assert rectangles(alone) == rectangles(scene[2])
    assert scene[2]["integrator"]["type"] == "path"


# ---- the command -----------------------------------------------------------------------------------------


def test_without_mitsuba_one_line_says_what_to_install(made, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "mitsuba", None)
    with pytest.raises(ValueError, match=r"^Mitsuba is not installed; pip install 'macram\[mitsuba\]'$"):
        run("compare", made, "-o", tmp_path / "x.png")
    assert not (tmp_path / "x.png").exists()


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--frames", "0"], "--frames must be 1 or more, not 0"),
        (["--samples", "0"], "--samples must be 1 or more, not 0"),
        (["-o", "x.gif"], "x.gif: the comparison is a .png or .jpg file"),
    ],
)
def test_bad_arguments_are_named(made, words, message):
    with pytest.raises(ValueError, match=message):
        run("compare", made, *words)


def test_other_folders_are_refused(made, tmp_path):
    with pytest.raises(ValueError, match=r"dataset\.json: file is missing"):
        run("compare", tmp_path)
    copy = shutil.copytree(made, tmp_path / "copy")
    text = (copy / "dataset.json").read_text()
    (copy / "dataset.json").write_text(text.replace('"seed": 3', '"seed": 4'))
    with pytest.raises(ValueError, match="only data sets of this version's"):
        run("compare", copy)
    (copy / "dataset.json").write_text("{}")
    with pytest.raises(ValueError, match="not from `macram data render`"):
        run("compare", copy)


def test_mitsuba_sees_the_same_silhouettes(made, tmp_path):
    from macram.data.compare import chosen_frames, compare  # noqa: PLC0415

    spec, frames = chosen_frames(made, None, 4)
    assert len(frames) == 4
    compared = 0
    for frame in frames:
        found = compare(spec, frame, 16)
        assert found.overlap > 0.97, frame.name
        # What differs lies on the outline.
        inside = cv2.erode(found.our_mask.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
        assert found.their_mask[inside].all()
        assert found.theirs.shape == found.ours.shape
        # Same surfaces under the same Sun: the two rise and fall together. Light from one part on another, which
        # only Mitsuba follows, is all there is on a target that hides its sunlit side.
        one, other = (p[found.our_mask].astype(float).ravel() for p in (found.ours, found.theirs))
        if one.mean() > 10:
            compared += 1
            assert np.corrcoef(one, other)[0, 1] > 0.7, frame.name
    assert compared == 3
    assert run("compare", made, "--frames", 1, "--samples", 4, "-o", tmp_path / "sheet.png") == 0
    assert cv2.imread(str(tmp_path / "sheet.png")).shape == (64, 3 * 96, 3)
