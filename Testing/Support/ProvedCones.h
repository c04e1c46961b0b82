// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file ProvedCones.h
 * @brief Cone sets with a certificate, as vtkConeSetFilter writes them, without photons.
 */
#ifndef ProvedCones_h
#define ProvedCones_h

#include "scConeData.h"
#include "scFingerprints.h"
#include "scLightData.h"
#include "scMeshData.h"

#include "vtkAreaLightSource.h"
#include "vtkFieldData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <string>

namespace shadowcones
{
namespace testsupport
{

/// Cones around parts of the mesh, proved for it and the lamp.
inline vtkSmartPointer<vtkPolyData> ProvedConesOf(vtkPolyData* mesh, vtkAreaLightSource* lamp)
{
  TriangleMesh triangles;
  Light light;
  std::string error;
  lamp->Update();
  EXPECT_TRUE(ReadTriangles(mesh, triangles, error) && ReadLight(lamp->GetOutput(), light, error)) << error;
  ConeProof proof;
  EXPECT_TRUE(ProveConeSet(triangles.View(), { light }, {}, {}, {}, proof));
  auto cones = vtkSmartPointer<vtkPolyData>::New();
  WriteConeSet(proof.Cones, cones);
  WriteConeCertificate(CertificateOf(proof, proof.Cones, triangles.View(), { light }), cones->GetFieldData());
  WriteLightFingerprints({ light }, cones);
  WriteFingerprints(castersFingerprint, { CastersFingerprintOf(triangles) }, cones->GetFieldData());
  return cones;
}

/// Give a cone set, whatever it is, a certificate for a box; an empty one: for all of space. Its hash is of nothing.
inline void CertifyIn(const Box& box, vtkPolyData* cones)
{
  ConeCertificate certificate;
  certificate.Certified = true;
  certificate.Bounds = box;
  WriteConeCertificate(certificate, cones->GetFieldData());
}

} // namespace testsupport
} // namespace shadowcones

#endif
