// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file scPreparedScene.h
 * @brief What filters keep from run to run of what is costly to build: meshes, search trees, cones and grids.
 *
 * Each thing has a key of all that it is made from. A filter that finds its key takes it; else it builds it, and at the
 * end of its run everything is dropped that no filter of the scene has used in its last run. So a scene holds one run's
 * worth of things for each of its filters, what they share once.
 */
#ifndef scPreparedScene_h
#define scPreparedScene_h

#include "ShadowConesDataModule.h"
#include "scBox.h"
#include "scInputStamp.h"

#include "vtkObject.h"
#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace shadowcones
{

/// What a prepared thing is; each has a type of its own.
enum class PreparedKind : std::uint64_t
{
  Mesh,
  Casters,
  Occluders,
  Reflectance,
  Normals,
  Cones,
  Proof,
  Grids,
  SoftGrids,
  Density,
  Photons
};

/// All that a thing is made from.
class SHADOWCONESDATA_EXPORT PreparedKey
{
public:
  explicit PreparedKey(PreparedKind kind);

  PreparedKey& Add(std::uint64_t word);
  PreparedKey& Add(double number); ///< by its bits
  PreparedKey& Add(const Box& box);
  PreparedKey& Add(const InputStamp& stamp); ///< but for its update: each pipeline that it stands in has its own
  PreparedKey& Add(const std::vector<InputStamp>& stamps);

  bool operator==(const PreparedKey& other) const { return this->Words == other.Words; }

private:
  std::vector<std::uint64_t> Words;
};

/// Something that is costly to build.
struct SHADOWCONESDATA_EXPORT PreparedItem
{
  PreparedItem();
  virtual ~PreparedItem();
  PreparedItem(const PreparedItem&) = delete;
  PreparedItem& operator=(const PreparedItem&) = delete;

  virtual std::int64_t Memory() const = 0; ///< bytes
  const std::uint64_t Id;                  ///< no two are alike: for the keys of what is made from it
};

/// What some filters keep. Safe from several threads.
class SHADOWCONESDATA_EXPORT PreparedScene : public vtkObject
{
public:
  static PreparedScene* New();
  vtkTypeMacro(PreparedScene, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// nullptr where there is none of that key. The user is noted with the number of its run.
  std::shared_ptr<const PreparedItem> Find(const PreparedKey& key, const void* user, std::uint64_t run);
  void Keep(
    const PreparedKey& key, const std::shared_ptr<const PreparedItem>& item, const void* user, std::uint64_t run);
  /// Drop what neither that run of the user nor any other user has used.
  void DropUnused(const void* user, std::uint64_t run);
  /// The user is gone. What it used stays until another one's run ends without it.
  void Leave(const void* user);
  void DropAll();
  /// Bytes of all that is kept.
  std::int64_t Memory();

protected:
  PreparedScene() = default;
  ~PreparedScene() override = default;

private:
  struct Entry
  {
    PreparedKey Key;
    std::shared_ptr<const PreparedItem> Item;
    std::map<const void*, std::uint64_t> Users; ///< and their last run that used it
  };

  std::mutex Lock;
  std::vector<Entry> Entries;
};

/// A filter's part in a prepared scene: its own one, or that of another.
class SHADOWCONESDATA_EXPORT PreparedUser
{
public:
  PreparedUser();
  ~PreparedUser();
  PreparedUser(const PreparedUser&) = delete;
  PreparedUser& operator=(const PreparedUser&) = delete;

  vtkObject* GetScene() const { return this->Scene; }
  /// @return false where it is not the scene of a filter. nullptr: a scene of its own again.
  bool SetScene(vtkObject* scene);
  void Release() { this->Scene->DropAll(); }
  std::int64_t Memory() const { return this->Scene->Memory(); }
  vtkIdType NumberOfBuilds() const { return this->Builds; }

  /// What stands under the key, built by make() where nothing does; what make() gives as nullptr is not kept.
  template <typename Item, typename Make>
  std::shared_ptr<const Item> Get(const PreparedKey& key, const Make& make)
  {
    this->UsesAny = true;
    if (std::shared_ptr<const PreparedItem> found = this->Scene->Find(key, this, this->Run))
    {
      return std::static_pointer_cast<const Item>(found);
    }
    std::shared_ptr<const Item> made = make();
    if (made)
    {
      this->Builds += 1;
      this->Scene->Keep(key, made, this, this->Run);
    }
    return made;
  }

  void BeginRun();
  /// A run that used nothing, as where its parameters were wrong, changes nothing.
  void EndRun();

private:
  vtkSmartPointer<PreparedScene> Scene;
  std::uint64_t Run = 0;
  bool UsesAny = false;
  vtkIdType Builds = 0;
};

/// One run of a filter; from its beginning to its end.
class PreparedRun
{
public:
  explicit PreparedRun(PreparedUser& user)
    : User(user)
  {
    user.BeginRun();
  }
  ~PreparedRun() { this->User.EndRun(); }
  PreparedRun(const PreparedRun&) = delete;
  PreparedRun& operator=(const PreparedRun&) = delete;

private:
  PreparedUser& User;
};

/// Bytes of an array.
template <typename T>
std::int64_t MemoryOf(const std::vector<T>& values)
{
  return static_cast<std::int64_t>(values.capacity() * sizeof(T));
}

} // namespace shadowcones

/// The five methods of a filter with a PreparedUser in this->Prepared.
#define scDefinePreparedScene(Class)                                                                                   \
  vtkObject* Class::GetPreparedScene()                                                                                 \
  {                                                                                                                    \
    return this->Prepared->GetScene();                                                                                 \
  }                                                                                                                    \
  void Class::SetPreparedScene(vtkObject* scene)                                                                       \
  {                                                                                                                    \
    if (!this->Prepared->SetScene(scene))                                                                              \
    {                                                                                                                  \
      vtkErrorMacro("A " << scene->GetClassName() << " is no prepared scene: hand over what GetPreparedScene() of "    \
                         << "another filter gives.");                                                                  \
    }                                                                                                                  \
  }                                                                                                                    \
  void Class::ReleasePreparedScene()                                                                                   \
  {                                                                                                                    \
    this->Prepared->Release();                                                                                         \
  }                                                                                                                    \
  vtkTypeInt64 Class::GetPreparedMemory()                                                                              \
  {                                                                                                                    \
    return this->Prepared->Memory();                                                                                   \
  }                                                                                                                    \
  vtkIdType Class::GetNumberOfPreparations()                                                                           \
  {                                                                                                                    \
    return this->Prepared->NumberOfBuilds();                                                                           \
  }

#endif
