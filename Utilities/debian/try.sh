#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Inside a fresh system: install the packages in /packages and use each as its user would.
set -eu
export DEBIAN_FRONTEND=noninteractive LC_ALL=C

dpkg --configure -a >/packages/configure.log 2>&1 || true
apt-get -q install -y --no-install-recommends /packages/*.deb cmake g++ make >/packages/install.log 2>&1 || {
  tail -n 20 /packages/install.log >&2
  exit 1
}
dpkg-query -W -f '${Package} ${Version} ${db:Status-Status}\n' 'libshadowcones*' 'python3-shadowcones' 'shadowcones*'

printf '\nPython: '
python3 - <<'PYTHON'
import shadowcones as sc
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource

cube = vtkCubeSource()
light = sc.vtkAreaLightSource()
light.SetShapeToSun()
light.SetNormal(0, -1, 0)
below = vtkPlaneSource()
below.SetOrigin(-0.1, -1, -0.1)
below.SetPoint1(0.1, -1, -0.1)
below.SetPoint2(-0.1, -1, 0.1)
probe = sc.vtkConeSetProbe()
probe.SetInputConnection(below.GetOutputPort())
probe.SetMeshConnection(cube.GetOutputPort())
probe.SetLightConnection(light.GetOutputPort())
probe.Update()
visible = probe.GetOutput().GetPointData().GetArray("Visibility").GetRange()
print("visible below a cube:", visible)
assert visible == (0.0, 0.0)
PYTHON

printf '\nA program of its own:\n'
cmake --fresh -S /packages/Consumer -B /packages/consumer-build >/packages/consumer.log 2>&1 && cmake --build /packages/consumer-build >>/packages/consumer.log 2>&1 || {
  tail -n 20 /packages/consumer.log >&2
  exit 1
}
/packages/consumer-build/consumer

if command -v shadowcones >/dev/null 2>&1; then
  printf '\nThe command:\n'
  shadowcones --version
  meshes=$(dpkg -L shadowcones-doc | sed -n 's|/chair.vtp$||p')
  (cd /packages && shadowcones image "$meshes/chair.vtp" --size 160x120 -q -o chair.png && test -s chair.png)
  printf 'a picture of light shafts: %s bytes\n' "$(stat -c %s /packages/chair.png)"
fi
printf '\nEvery package installs and works.\n'
