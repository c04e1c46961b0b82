// SPDX-License-Identifier: BSD-3-Clause
#include "scPreparedScene.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace shadowcones
{
namespace
{
std::uint64_t NextId()
{
  static std::atomic<std::uint64_t> last{ 0 };
  return ++last;
}
} // anonymous namespace

PreparedKey::PreparedKey(PreparedKind kind)
{
  this->Add(static_cast<std::uint64_t>(kind));
}

PreparedKey& PreparedKey::Add(std::uint64_t word)
{
  this->Words.push_back(word);
  return *this;
}

PreparedKey& PreparedKey::Add(double number)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  return this->Add(bits);
}

PreparedKey& PreparedKey::Add(const Box& box)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Add(box.Min[axis]).Add(box.Max[axis]);
  }
  return *this;
}

PreparedKey& PreparedKey::Add(const InputStamp& stamp)
{
  return this->Add(static_cast<std::uint64_t>(reinterpret_cast<std::uintptr_t>(stamp.Data)))
    .Add(static_cast<std::uint64_t>(stamp.Changed));
}

PreparedKey& PreparedKey::Add(const std::vector<InputStamp>& stamps)
{
  this->Add(static_cast<std::uint64_t>(stamps.size()));
  for (const InputStamp& stamp : stamps)
  {
    this->Add(stamp);
  }
  return *this;
}

PreparedItem::PreparedItem()
  : Id(NextId())
{
}

PreparedItem::~PreparedItem() = default;

vtkStandardNewMacro(PreparedScene);

std::shared_ptr<const PreparedItem> PreparedScene::Find(const PreparedKey& key, const void* user, std::uint64_t run)
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  for (Entry& entry : this->Entries)
  {
    if (entry.Key == key)
    {
      entry.Users[user] = run;
      return entry.Item;
    }
  }
  return nullptr;
}

void PreparedScene::Keep(
  const PreparedKey& key, const std::shared_ptr<const PreparedItem>& item, const void* user, std::uint64_t run)
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  this->Entries.push_back({ key, item, { { user, run } } });
}

void PreparedScene::DropUnused(const void* user, std::uint64_t run)
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  for (Entry& entry : this->Entries)
  {
    const auto found = entry.Users.find(user);
    if (found != entry.Users.end() && found->second != run)
    {
      entry.Users.erase(found);
    }
  }
  this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                        [](const Entry& entry) { return entry.Users.empty(); }),
    this->Entries.end());
}

void PreparedScene::Leave(const void* user)
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  for (Entry& entry : this->Entries)
  {
    entry.Users.erase(user);
  }
}

void PreparedScene::DropAll()
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  this->Entries.clear();
}

std::int64_t PreparedScene::Memory()
{
  const std::lock_guard<std::mutex> lock(this->Lock);
  std::int64_t bytes = 0;
  for (const Entry& entry : this->Entries)
  {
    bytes += entry.Item->Memory();
  }
  return bytes;
}

void PreparedScene::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Memory: " << this->Memory() << "\n";
}

PreparedUser::PreparedUser()
  : Scene(vtkSmartPointer<PreparedScene>::New())
{
}

PreparedUser::~PreparedUser()
{
  this->Scene->Leave(this);
}

bool PreparedUser::SetScene(vtkObject* scene)
{
  auto* prepared = PreparedScene::SafeDownCast(scene);
  if (scene && !prepared)
  {
    return false;
  }
  if (!prepared || prepared != this->Scene)
  {
    this->Scene->Leave(this);
    this->Scene = prepared ? vtkSmartPointer<PreparedScene>(prepared) : vtkSmartPointer<PreparedScene>::New();
  }
  return true;
}

void PreparedUser::BeginRun()
{
  this->Run += 1;
  this->UsesAny = false;
}

void PreparedUser::EndRun()
{
  if (this->UsesAny)
  {
    this->Scene->DropUnused(this, this->Run);
  }
}

} // namespace shadowcones
