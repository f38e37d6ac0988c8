#ifndef qFaceToBonePlanPanel_h
#define qFaceToBonePlanPanel_h

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QSlider;
class QVBoxLayout;
class qFaceToBoneCase;

/// How do the fragments move? Six numbers a fragment, which may be changed by hand.
class qFaceToBonePlanPanel : public QWidget
{
  Q_OBJECT

public:
  qFaceToBonePlanPanel(qFaceToBoneCase* work, QWidget* parent = nullptr);

  double shareShown() const; ///< of the movement, by the slider

signals:
  /// Why a rule cannot be taken.
  void refused(const QString& why);
  /// The gizmo is wanted in the 3D view.
  void handChanged(bool on);

private:
  struct FragmentBox
  {
    QWidget* box = nullptr;
    QString fragment;
    QDoubleSpinBox* numbers[6]{}; ///< right, forward, up [mm], pitch, roll, yaw [degrees]
    QWidget* rules = nullptr;     ///< shown on demand
    QCheckBox *locks[6]{}, *bounds[6]{};
    QDoubleSpinBox *least[6]{}, *most[6]{};
    QLabel* restraint = nullptr;
  };
  void makeRules(FragmentBox& made);
  void updateRules(const FragmentBox& box);
  void applyRule(const FragmentBox& box, int coordinate);
  FragmentBox makeBox(const QString& fragment);
  void update();
  void apply(const FragmentBox& box);

  qFaceToBoneCase* m_case;
  QCheckBox *m_follow, *m_hand;
  QSlider* m_shown;
  QVBoxLayout* m_boxes;
  QLabel *m_state, *m_notes;
  std::vector<FragmentBox> m_fragments;
};

#endif
