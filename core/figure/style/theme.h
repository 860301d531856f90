#pragma once

namespace kriva {

enum class Theme { light, dark };

} // namespace kriva
