#pragma once
// Packs data for the device once when many threads need it at the same time.

#include <map>
#include <memory>
#include <mutex>

namespace gpu {

template <class Key, class Packed>
class PackOnce {
 public:
  // Returns the result of `pack`, computed once for all threads with this key while any of them
  // holds it. Others wait.
  template <class Pack>
  std::shared_ptr<const Packed> get(const Key& key, const Pack& pack) {
    std::shared_ptr<Packing> packing;
    {
      const std::scoped_lock lock(mutex_);
      std::erase_if(packings_, [](const auto& known) { return known.second.expired(); });
      packing = packings_[key].lock();
      if (!packing) {
        packing = std::make_shared<Packing>();
        packings_[key] = packing;
      }
    }
    std::call_once(packing->once, [&] { packing->packed = pack(); });
    return {packing, &packing->packed};
  }

 private:
  struct Packing {
    std::once_flag once;
    Packed packed;
  };

  std::mutex mutex_;
  std::map<Key, std::weak_ptr<Packing>> packings_;
};

}  // namespace gpu
