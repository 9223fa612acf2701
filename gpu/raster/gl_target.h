#pragma once
// Pictures on the device that triangles are drawn into.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace gpu {

enum class Layer { depth, value, colour };  // 32-bit float; 32-bit float; 8-bit RGBA

// One texture for each layer, all of one size. All calls, also the destructor, need the context
// current in which it was made. They throw GlError.
class GlTarget {
 public:
  // what: for messages, "shadow maps". Not larger than largest_side().
  GlTarget(std::string what, int width, int height, const std::vector<Layer>& layers);
  ~GlTarget();
  GlTarget(const GlTarget&) = delete;
  GlTarget& operator=(const GlTarget&) = delete;

  static int largest_side();
  int width() const { return width_; }
  int height() const { return height_; }

  // Directs further drawing here, layers other than depth to outputs 0, 1, ... in order.
  void draw_into() const { draw_into(width_, height_); }
  // Does the same for the first columns and the lowest rows.
  void draw_into(int width, int height) const;
  // Binds a layer as a sampler of shaders.
  void bind_texture(std::size_t layer, unsigned unit) const;
  // Reads the first columns and lowest rows of a layer that is not depth, lowest row first, 4 bytes
  // a pixel. Requires that it was drawn into after any other target.
  void read(std::size_t layer, int width, int height, std::span<std::byte> to) const;

 private:
  void make(const std::vector<Layer>& layers);
  void release();

  std::string what_;
  int width_, height_;
  unsigned frame_ = 0;
  std::vector<Layer> layer_;
  std::vector<unsigned> texture_;
};

}  // namespace gpu
