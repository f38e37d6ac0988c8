#ifndef qFaceToBoneCutTools_h
#define qFaceToBoneCutTools_h

#include <QObject>

#include <vtkSmartPointer.h>

#include <vector>

class qFaceToBoneCase;
class qFaceToBoneThreeDView;
class vtkFaceToBoneCurveWidget;
class vtkFaceToBonePlaneWidget;
class vtkFaceToBoneSawWidget;
class vtkFaceToBoneToolWidget;
class vtkObject;

/// The cuts in the 3D view: planes, lines with their saws, and the ball on the piece that is to be
/// free; those of the current cut can be dragged. And the pen that draws new lines.
class qFaceToBoneCutTools : public QObject
{
  Q_OBJECT

public:
  qFaceToBoneCutTools(qFaceToBoneCase* work, qFaceToBoneThreeDView* view, QObject* parent);
  ~qFaceToBoneCutTools() override;

  void show(bool on);
  /// Draws a line on the bone: a cut of its own, or one more of the current cut.
  bool startDrawing(bool ofCurrent);
  /// Takes what is drawn, if that is a line. \return whether it was
  bool finishDrawing();
  void dropDrawing();
  bool isDrawing() const { return m_drawing; }

  /// What the tools of one part are; those that it has not are null.
  struct Part
  {
    int cut = 0, index = 0; ///< index: of its planes, or of its curves
    vtkSmartPointer<vtkFaceToBonePlaneWidget> plane;
    vtkSmartPointer<vtkFaceToBoneCurveWidget> line; ///< the ball too: then it has no saw
    vtkSmartPointer<vtkFaceToBoneSawWidget> saw;
  };
  const std::vector<Part>& parts() const { return m_parts; }
  vtkFaceToBoneCurveWidget* pen() const;

signals:
  void drawingChanged(bool on);
  /// How near the cut that is dragged comes to what it should spare; empty: not.
  void told(const QString& text);

private:
  using Layout = std::vector<std::vector<int>>;
  Layout layout() const;
  void update();
  void rebuild();
  void place(Part& part);
  void addPlane(int cut, int index);
  void addLine(int cut, int index);
  void addBall(int cut);
  template <class Tool>
  vtkSmartPointer<Tool> makeTool(bool current, float priority);
  void drop();
  void partMoved(vtkObject* tool, unsigned long, void*);
  void dragBegan(vtkObject*, unsigned long, void*);
  void dragEnded(vtkObject*, unsigned long, void*);
  void penMoved(vtkObject*, unsigned long, void*);
  void penFinished(vtkObject*, unsigned long, void*);
  void tellClearance();
  bool readBone();

  qFaceToBoneCase* m_case;
  qFaceToBoneThreeDView* m_view;
  std::vector<Part> m_parts;
  Layout m_layout;
  vtkSmartPointer<vtkFaceToBoneCurveWidget> m_pen;
  vtkSmartPointer<vtkFaceToBoneSawWidget> m_penSaw;
  vtkObject* m_bone = nullptr; ///< that the pen knows
  bool m_shown = false, m_drawing = false, m_ofCurrent = false;
  bool m_dragging = false, m_speaking = false;
};

#endif
