#pragma once

#include <cstring>

/// The i-th of an enum's texts; `otherwise` where there is none.
template <int Count>
const char* vtkMRMLEnumText(const char* const (&texts)[Count], int i, const char* otherwise = "")
{
  return i < 0 || i >= Count ? otherwise : texts[i];
}

/// Which of an enum's texts; -1 where it is none.
template <int Count>
int vtkMRMLEnumFromText(const char* const (&texts)[Count], const char* text)
{
  for (int i = 0; text && i < Count; ++i)
  {
    if (std::strcmp(texts[i], text) == 0)
    {
      return i;
    }
  }
  return -1;
}
