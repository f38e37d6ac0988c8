#include "qFaceToBoneObjects.h"

#include <vtkPolyData.h>

#include <algorithm>

const qFaceToBoneObject* qFaceToBoneObjects::find(const QString& key) const
{
  const auto found = std::find_if(m_objects.begin(), m_objects.end(),
                                  [&](const qFaceToBoneObject& o) { return o.key == key; });
  return found == m_objects.end() ? nullptr : &*found;
}

qFaceToBoneObject* qFaceToBoneObjects::of(const QString& key)
{
  return const_cast<qFaceToBoneObject*>(find(key));
}

void qFaceToBoneObjects::put(const qFaceToBoneObject& object)
{
  if (qFaceToBoneObject* there = of(object.key))
  {
    there->name = object.name;
    there->surface = object.surface;
    there->matrix = object.matrix;
    emit objectChanged(object.key);
    return;
  }
  m_objects.push_back(object);
  emit listChanged();
}

void qFaceToBoneObjects::remove(const QString& key)
{
  const auto kept = std::remove_if(m_objects.begin(), m_objects.end(),
                                   [&](const qFaceToBoneObject& o) { return o.key == key; });
  if (kept == m_objects.end())
    return;
  m_objects.erase(kept, m_objects.end());
  emit listChanged();
}

void qFaceToBoneObjects::clear()
{
  m_objects.clear();
  emit listChanged();
}

void qFaceToBoneObjects::setVisible(const QString& key, bool visible)
{
  qFaceToBoneObject* object = of(key);
  if (!object || object->visible == visible)
    return;
  object->visible = visible;
  emit objectChanged(key);
}

void qFaceToBoneObjects::setOpacity(const QString& key, double opacity)
{
  qFaceToBoneObject* object = of(key);
  if (!object || object->opacity == opacity)
    return;
  object->opacity = opacity;
  emit objectChanged(key);
}

void qFaceToBoneObjects::setColour(const QString& key, const QColor& colour)
{
  qFaceToBoneObject* object = of(key);
  if (!object || object->colour == colour)
    return;
  object->colour = colour;
  emit objectChanged(key);
}

void qFaceToBoneObjects::setMatrix(const QString& key, const std::array<double, 16>& matrix)
{
  qFaceToBoneObject* object = of(key);
  if (!object || object->matrix == matrix)
    return;
  object->matrix = matrix;
  emit objectChanged(key);
}

void qFaceToBoneObjects::setColouring(const QString& key, const QString& array, double range,
                                      bool diverging)
{
  qFaceToBoneObject* object = of(key);
  if (!object)
    return;
  object->colourArray = array;
  object->range = range;
  object->diverging = diverging;
  emit objectChanged(key);
}
