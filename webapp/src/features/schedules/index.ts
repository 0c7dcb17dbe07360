export { Calendars } from './Calendars';
export { useSchedule } from './queries';
export { ScheduleDetails } from './ScheduleDetails';
export { ScheduleForm } from './ScheduleForm';
export { ScheduleList } from './ScheduleList';
export { titleOf } from './words';
